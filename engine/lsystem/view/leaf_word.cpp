#include "engine/lsystem/view/leaf_word.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace tractus::lsystem {

namespace {

struct DamageNumber {
    // Name of the damage parameter. It is part of the names of sheets in sessions and must never
    // change.
    std::string_view name;
    double LeafDamage::*number;
    double most;
};

constexpr std::array<DamageNumber, 5> kDamageNumbers { { { "spots", &LeafDamage::spots, 1 },
                                                         { "mildew", &LeafDamage::mildew, 1 },
                                                         { "mines", &LeafDamage::mines, 20 },
                                                         { "larvae", &LeafDamage::larvae, 20 },
                                                         { "withered", &LeafDamage::withered,
                                                           1 } } };

// Parses a part such as "spots=0.3" and sets the damage. Returns false if the part is not a damage
// parameter.
bool take_number(std::string_view part, LeafDamage& damage)
{
    auto const equals = part.find('=');
    auto const known
        = std::ranges::find(kDamageNumbers, part.substr(0, equals), &DamageNumber::name);
    if (equals == std::string_view::npos || known == kDamageNumbers.end())
        return false;
    auto const digits = part.substr(equals + 1);
    double value = 0;
    auto const read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()
        || !(value >= 0 && value <= known->most))
        return false;
    damage.*known->number = value;
    return true;
}

} // namespace

std::string leaf_word(LeafWord const& wanted)
{
    auto word = wanted.grammar;
    for (auto const& [name, number, most] : kDamageNumbers)
        if (double const value = wanted.damage.*number; value > 0)
            word += fmt::format("+{}={}", name, std::min(value, most));
    return word;
}

LeafWord parse_leaf_word(std::string_view word)
{
    LeafWord wanted;
    for (auto plus = word.rfind('+'); plus != std::string_view::npos; plus = word.rfind('+')) {
        if (!take_number(word.substr(plus + 1), wanted.damage))
            break;
        word = word.substr(0, plus);
    }
    wanted.grammar = word;
    return wanted;
}

Result<void> check_leaf_name(std::string_view grammar)
{
    auto const plus = grammar.rfind('+');
    if (plus == std::string_view::npos || grammar.find('=', plus) == std::string_view::npos)
        return {};
    std::string expected;
    for (auto const& [name, number, most] : kDamageNumbers)
        expected += fmt::format("{}{} (0 to {})", expected.empty() ? "" : ", ", name, most);
    return fail(
        Fault::User,
        fmt::format("a leaf's damage: found {}, expected {}", grammar.substr(plus + 1), expected));
}

} // namespace tractus::lsystem
