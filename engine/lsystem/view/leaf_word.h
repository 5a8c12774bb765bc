#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>

namespace tractus::lsystem {

// What a leaf has suffered. Of many leaves, how much one of them has on the average.
struct LeafDamage {
    double spots = 0;    // Share that has brown spots, 0 to 1.
    double mildew = 0;   // Share that is white with mildew, 0 to 1.
    double mines = 0;    // Pale ways that larvae have eaten under its skin, 0 to 20.
    double larvae = 0;   // Larvae that have eaten holes, 0 to 20.
    double withered = 0; // How far the colour of old leaves has become that of dead ones, 0 to 1.

    bool operator==(LeafDamage const&) const = default;
};

// A grammar and what is done to its leaves, which is what an order (leaf_sheet.h) has in place of a
// grammar's name: "oak", "oak+spots=0.3+larvae=2".
struct LeafWord {
    std::string grammar {};
    LeafDamage damage {};

    bool operator==(LeafWord const&) const = default;
};

// The word: each number that is not 0 stands behind the grammar.
std::string leaf_word(LeafWord const& wanted);

// What a word says. What is no number of LeafDamage in its range belongs to the grammar's name.
LeafWord parse_leaf_word(std::string_view word);

// A grammar's name that ends in what should have been a number of LeafDamage, "oak+spots=3", fails
// as the user's fault, with the numbers that there are and their ranges.
Result<void> check_leaf_name(std::string_view grammar);

} // namespace tractus::lsystem
