#pragma once

#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_blade.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <vector>

namespace tractus::leaf {

// The standard deviation of the hand's tremor, from how far veins are from smooth curves; a share
// of the blade's length.
double tremor_of(FlatBlade const& blade);

// Numbers of the main and side veins.
struct FittedVeins {
    std::vector<DrawnLeaf::Main> mains {}; // In DrawnLeaf's order.
    double hub = 0;
    double side_curve_deg = 0;           // Curve of veins at their parents' begin,
    double side_curve_at_tip_deg = 0;    // and at their end.
    std::vector<LeafFit::Vein> veins {}; // Mains, then sides, as recognised.
};

// `outline` is the fitted one: main veins reach it. A single vein's angle is hardly to be seen in
// a short stroke: it is drawn towards what the veins beside it say, the more so the shorter it is.
// Fails, as the user's fault, where too many veins begin on one.
Result<FittedVeins> fit_veins(RecognisedLeaf const& leaf, FlatBlade const& blade,
                              Outline const& outline, double tremor);

} // namespace tractus::leaf
