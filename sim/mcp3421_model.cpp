#include "sim/mcp3421_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::sim {

Mcp3421Model::Mcp3421Model(std::function<double()> input)
    : input_(std::move(input))
{
}

// Stores the last byte as the configuration. Its bit 7, "ready", would start a conversion and is
// not stored.
void Mcp3421Model::write(std::span<std::byte const> bytes)
{
    if (!bytes.empty())
        configuration_ = bytes.back() & std::byte { 0x7f };
}

int Mcp3421Model::bits() const
{
    return 12 + 2 * std::to_integer<int>(configuration_ >> 2 & std::byte { 3 });
}

std::vector<std::byte> Mcp3421Model::read(std::size_t size)
{
    auto const greatest = (1L << (bits() - 1)) - 1;
    auto const code = std::clamp(std::lround(input_() * static_cast<double>(greatest)),
                                 -greatest - 1, greatest);
    std::vector<std::byte> bytes;
    for (int shift = bits() > 16 ? 16 : 8; shift >= 0; shift -= 8)
        bytes.push_back(static_cast<std::byte>(code >> shift));
    bytes.resize(std::max(bytes.size() + 1, size), configuration_);
    bytes.resize(size);
    return bytes;
}

} // namespace tractus::sim
