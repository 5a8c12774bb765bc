#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// Damage of a leaf; for several leaves, the average damage.
struct LeafDamage {
    double spots = 0;  // Share of the leaf that brown spots cover, 0 to 1.
    double mildew = 0; // Share of the leaf that white mildew covers, 0 to 1.
    double mines = 0; // Number of pale leaf mines, tunnels that larvae eat under the skin, 0 to 20.
    double larvae = 0;   // Number of larvae that have eaten holes, 0 to 20.
    double withered = 0; // Degree to which old leaves have taken the colour of dead ones, 0 to 1.

    bool operator==(LeafDamage const&) const = default;
};

// A leaf grammar with damage, which an order (leaf_sheet.h) may name instead of a plain grammar:
// "oak+spots=0.3+larvae=2" instead of "oak".
struct LeafWord {
    std::string grammar {};
    LeafDamage damage {};

    bool operator==(LeafWord const&) const = default;
};

// Formats a grammar with its damage. Damage parameters that are 0 are omitted.
std::string leaf_word(LeafWord const& wanted);

// Parses a grammar with its damage. Any part that is not a valid damage parameter counts as part of
// the grammar's name.
LeafWord parse_leaf_word(std::string_view word);

// Checks the name of a grammar. Fails with a user error if it ends in an invalid damage parameter,
// as in "oak+spots=3"; the message lists the parameters and their ranges.
Result<void> check_leaf_name(std::string_view grammar);

} // namespace tractus::lsystem
