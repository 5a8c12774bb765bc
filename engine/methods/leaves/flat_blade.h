#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <span>
#include <vector>

namespace tractus::leaf {

// Position and orientation of a blade in its drawing, in the drawing's millimetres.
struct BladePlace {
    Vec3 base_mm = Vec3::Zero(); // Base of the blade, at the petiole.
    Vec3 tip_mm = Vec3::UnitY();
    // Normal of the upper side, perpendicular to the line from base to tip.
    Vec3 normal = Vec3::UnitZ();
};

// A drawn leaf laid out flat: its midrib is straight, and the blade has neither bend nor rise.
//
// The origin is the beginning of the blade at the petiole; x is to the right, y along the midrib,
// and the tip is at (0, 1). Lengths along and across the midrib are preserved.
struct FlatBlade {
    // Length of the midrib within the blade: the unit of all other lengths here except in `place`.
    double size_mm = 0;
    double stalk = 0;  // Length of the petiole, as a share of size_mm; 0 if none was drawn.
    FlatLine right {}; // Right half outline, from base to tip.
    // Left half outline, with negative x. Empty if only one half was drawn; `right` contains it.
    FlatLine left {};
    std::vector<FlatLine> mains {};
    std::vector<FlatLine> sides {};
    double bend_low_deg = 0;  // Downward bend of the midrib over its lower half.
    double bend_high_deg = 0; // Downward bend of the midrib over its upper half.
    double rise_deg = 0;      // Upward angle of the blade on both sides of the midrib.
    double sweep_deg = 0;     // Sideways turn of the drawn midrib from base to tip.
    BladePlace place {};
};

// Lays a recognised leaf out flat. Fails with a user error if the outline does not surround the
// midrib.
Result<FlatBlade> lay_flat(RecognisedLeaf const& leaf);

} // namespace tractus::leaf
