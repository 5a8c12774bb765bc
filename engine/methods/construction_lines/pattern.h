#pragma once

#include <string>

namespace tractus::lines {

// How organs stand around the stem (phyllotaxis).
struct Pattern {
    enum class Kind {
        Distichous, // At each node one on the left and one on the right.
        Decussate,  // Pairs, each across the one below.
        Spiral,     // One at each node, turned by the divergence from the one below.
        Alternate,  // Also so; without a divergence they stand left and right in turn.
        Whorled,    // Several, evenly around; from node to node turned by half their distance.
        Bare,       // No organs: the stem alone.
    };

    // How sizes change around the stem between its left and its right. Between boundaries in space
    // they follow half-ellipses, whatever is said here.
    enum class Sizes {
        Linear, // As the paper has it.
        HalfEllipses,
    };

    // How an organ is turned about its own length.
    enum class Face {
        Pattern, // Distichous ones flat, all others with the upper side up.
        Flat,    // Its edges to the stem's foot and top: as in a frond.
        Up,      // Its upper side to the stem's top,
        Down,    // or to its foot.
    };

    Kind kind = Kind::Distichous;
    double divergence_deg = 137.5; // Spiral and Alternate; -360 to 360.
    int whorl = 3;                 // Whorled: how many, 2 to 24.
    Sizes sizes = Sizes::Linear;
    Face face = Face::Pattern;

    bool operator==(Pattern const&) const = default;
};

// The pattern's word, in small letters.
std::string name_of(Pattern::Kind kind);

// The turn of its organs about their length, degrees from flat, counted as a turtle rolls.
double roll_deg(Pattern const& pattern);

// How many organs stand at a node.
int organs_at_node(Pattern const& pattern);

// Whether some organs stand elsewhere than on the stem's left and right, so that it matters how
// sizes change around it.
bool stands_all_around(Pattern const& pattern);

} // namespace tractus::lines
