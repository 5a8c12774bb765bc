#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <span>
#include <vector>

namespace tractus::leaf {

// Where a blade is in its drawing, in the drawing's millimetres.
struct BladePlace {
    Vec3 base_mm = Vec3::Zero(); // At the stalk.
    Vec3 tip_mm = Vec3::UnitY();
    Vec3 normal = Vec3::UnitZ(); // Out of its upper side, across the line from base to tip.
};

// A drawn leaf laid out flat: its midrib straight, without bend or rise.
//
// The blade's begin at the stalk is the origin; x is to the right, y along the midrib, the tip at
// (0, 1). What is measured along and across the midrib in space stays as long.
struct FlatBlade {
    double size_mm = 0; // Length of the midrib within the blade.
    double stalk = 0;   // As a share of that; 0: none is drawn.
    FlatLine right {};  // Halves of the outline from base to tip; the left one's x is negative.
    FlatLine left {};   // Empty: only one half is drawn, and given as the right one.
    std::vector<FlatLine> mains {};
    std::vector<FlatLine> sides {};
    double bend_low_deg = 0;  // Downwards, over the midrib's lower half,
    double bend_high_deg = 0; // and over its upper one.
    double rise_deg = 0;      // Rise of the blade on both sides of the midrib.
    double sweep_deg = 0;     // The midrib's turn sideways.
    BladePlace place {};
};

// Fails, as the user's fault, where the outline does not lie round the midrib.
Result<FlatBlade> lay_flat(RecognisedLeaf const& leaf);

} // namespace tractus::leaf
