#pragma once

#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_blade.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <vector>

namespace tractus::leaf {

// Standard deviation of the hand's tremor, estimated from the veins' deviations from smooth curves,
// as a share of the blade's length.
double tremor_of(FlatBlade const& blade);

// Parameters of the main and side veins.
struct FittedVeins {
    std::vector<DrawnLeaf::Main> mains {}; // Main veins in the order of DrawnLeaf::mains.
    double hub = 0;
    double side_curve_deg = 0;        // Curve of side veins at the beginning of their parents.
    double side_curve_at_tip_deg = 0; // Curve of side veins at the end of their parents.
    // Fit of each vein: first the main, then the side veins, in the order of RecognisedLeaf.
    std::vector<LeafFit::Vein> veins {};
};

// Fits the veins. `outline` is the fitted outline, which the main veins reach. The angle of a short
// stroke is uncertain, so it is shrunk towards the angles of neighbouring veins; more so for
// shorter strokes. Fails with a user error if too many veins begin on one vein.
Result<FittedVeins> fit_veins(RecognisedLeaf const& leaf, FlatBlade const& blade,
                              Outline const& outline, double tremor);

} // namespace tractus::leaf
