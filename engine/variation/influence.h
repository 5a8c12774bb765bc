#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/motion_indicator.h"
#include "engine/variation/rest_shape.h"

#include <span>
#include <vector>

namespace tractus::variation {

// Influence of the motion indicators on a plant, in units of the plant's height: an indicator as
// long as the plant is high has length 1, at any display scale.
struct Influence {
    Vec3 everywhere = Vec3::Zero();
    // For each segment, the influence to add to `everywhere`; empty: nothing is added.
    std::vector<Vec3> local {};

    bool is_none() const { return everywhere.isZero(0) && local.empty(); }
};

// How the plant is displayed in the drawing volume when indicators are drawn.
struct ShownPlant {
    double height_mm = 0; // Displayed height; above 0.
    double scale = 1;     // World millimetres per plant millimetre; above 0.
};

// Returns the total influence on growth as the vector sum of the indicators: for the whole plant,
// or by segment for indicators with a local effect. Positions of segments are those before growth:
// `nodes_mm` are the nodes of `plant` from place_nodes(), plant frame.
//
// Fails, in one sentence, if check_indicator() fails for an indicator, or if there are indicators
// and a number in `shown` is not above 0.
Result<Influence> influence_of(Plant const& plant, std::span<Vec3 const> nodes_mm,
                               std::span<MotionIndicator const> indicators,
                               ShownPlant const& shown);

} // namespace tractus::variation
