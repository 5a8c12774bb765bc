#pragma once

#include "engine/methods/leaves/drawn_leaf.h"
#include "engine/methods/leaves/flat_blade.h"
#include "engine/methods/leaves/leaf_drawing.h"
#include "engine/methods/leaves/leaf_outline.h"

#include <vector>

namespace tractus::leaf {

// Standard deviation of the hand's tremor, as a share of the blade's length. It is estimated from
// the deviations of the drawn veins from smooth curves.
double tremor_of(FlatBlade const& blade);

// Parameters of the main and side veins.
struct FittedVeins {
    std::vector<DrawnLeaf::Main> mains {}; // Main veins in the order of DrawnLeaf::mains.
    double hub = 0;
    double side_curve_deg = 0; // Turn of a side vein at its parent's beginning, as in DrawnLeaf.
    double side_curve_at_tip_deg = 0; // Turn of a side vein at its parent's end.
    // Fit of each vein, in the order of RecognisedLeaf: all main veins, then all side veins.
    std::vector<LeafFit::Vein> veins {};
};

// Fits the veins of a leaf. `outline` is the fitted outline, which the main veins reach; `tremor`
// is the result of tremor_of(). The measured angle of a short stroke is uncertain: the shorter the
// stroke, the more its angle is drawn towards those of the neighbouring veins. Fails with a user
// error if too many veins begin on one vein.
Result<FittedVeins> fit_veins(RecognisedLeaf const& leaf, FlatBlade const& blade,
                              Outline const& outline, double tremor);

} // namespace tractus::leaf
