#pragma once

#include <string>

namespace tractus::lines {

// Arrangement of organs around the stem (phyllotaxis).
struct Pattern {
    enum class Kind {
        Distichous, // Two organs per node, one on the left and one on the right.
        Decussate,  // Pairs of organs, each at right angles to the pair below.
        Spiral,     // One organ per node, rotated by the divergence angle from the one below.
        // One organ per node, on the left and right by turns if the divergence angle is 0.
        Alternate,
        // Several organs per node, evenly spaced; each whorl is rotated by half a spacing from the
        // one below.
        Whorled,
        Bare, // A stem without organs.
    };

    // How organ size varies around the stem between its left and its right side. Between boundaries
    // in space organ size always follows half-ellipses.
    enum class Sizes {
        Linear, // Linear in the azimuth (Anastacio et al. 2008).
        HalfEllipses,
    };

    // Rotation of an organ about its long axis.
    enum class Face {
        Pattern, // Flat for Distichous patterns, otherwise Up.
        Flat,    // Organs with their edges towards the stem's foot and top, as in a frond.
        Up,      // Organs with their upper side towards the stem's top.
        Down,    // Organs with their upper side towards the stem's foot.
    };

    Kind kind = Kind::Distichous;
    double divergence_deg = 137.5; // Divergence angle for Spiral and Alternate, -360 to 360.
    int whorl = 3;                 // Number of organs per node for Whorled, 2 to 24.
    Sizes sizes = Sizes::Linear;
    Face face = Face::Pattern;

    bool operator==(Pattern const&) const = default;
};

// Name of the pattern, in lower case.
std::string name_of(Pattern::Kind kind);

// Rotation of the organs about their long axes, in degrees from their position with Face::Flat,
// positive in the direction in which a turtle rolls.
double roll_deg(Pattern const& pattern);

// Number of organs at a node.
int organs_at_node(Pattern const& pattern);

// True if some organs of the pattern occur elsewhere than on the stem's left and right, so that it
// matters how sizes vary around the stem.
bool has_organs_all_around(Pattern const& pattern);

} // namespace tractus::lines
