#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::sim {

// A Microchip MCP3421, a converter of 12 to 18 bits with a sign on an I²C bus (data sheet DS22003):
// one byte configures it, and each reading is two or three bytes, most significant first, followed
// by the configuration. It converts whenever it is read; its gain is ignored. No clock and no
// randomness are used.
class Mcp3421Model {
public:
    static constexpr std::uint8_t kAddress = 0x68;

    // `input` returns the present input as a fraction of full scale, -1 to 1.
    explicit Mcp3421Model(std::function<double()> input);

    void write(std::span<std::byte const> bytes);
    std::vector<std::byte> read(std::size_t size);

    // Bits of a reading, including the sign: 12, 14, 16 or 18, by the configured rate.
    int bits() const;

private:
    std::function<double()> input_;
    std::byte configuration_ { 0x10 }; // As after power-up: continuous, 240 readings a second.
};

} // namespace tractus::sim
