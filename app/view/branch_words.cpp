#include "app/view/branch_words.h"

#include "engine/plant/plant_addresses.h"
#include "engine/scene/anchored.h"

#include <cstddef>
#include <fmt/core.h>

namespace tractus::view {

namespace {

std::string of_part(std::string const& words, std::uint64_t part)
{
    return fmt::format("{} of the plant {} that was put on", words, scene::name_of(part));
}

bool is_keyed(SegmentAddress const& address)
{
    return address.size() >= 4 && address[0] == kKeyedAxis;
}

// Describes a place on a plant. `keyed` is inserted after "a branch" if the address begins with an
// axis that is addressed by a key.
std::string words_of(SegmentAddress const& address, char const* keyed)
{
    std::string words;
    std::size_t begin = 0;
    if (is_keyed(address)) {
        words = fmt::format("{:.0f} % of a branch{}", address[3] / 0x1p31 * 100, keyed);
        begin = 4;
    }
    for (std::size_t i = begin; i + 1 < address.size(); i += 2) {
        auto const axis = fmt::format("{} {}", i == 0 ? "stem" : "branch", address[i] + 1);
        words = fmt::format("segment {} of {}{}{}", address[i + 1] + 1, axis,
                            words.empty() ? "" : " at ", words);
    }
    return words;
}

} // namespace

std::string place_in_words(SegmentAddress const& address)
{
    if (auto const part = part_of(address); part != 0)
        return of_part(place_in_words(without_part(part_prefix(part), address)), part);
    return words_of(address, " that is gone");
}

std::string branch_in_words(SegmentAddress const& address)
{
    if (auto const part = part_of(address); part != 0)
        return of_part(branch_in_words(without_part(part_prefix(part), address)), part);
    if (address.size() < 2 || (is_keyed(address) && address.size() == 4))
        return "a branch";
    auto const number = address[address.size() - 2] + 1;
    if (address.size() == 2)
        return fmt::format("stem {}", number);
    return fmt::format("branch {} at {}", number,
                       words_of(SegmentAddress(address.begin(), address.end() - 2), ""));
}

} // namespace tractus::view
