#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/motion_indicator.h"
#include "engine/variation/rest_shape.h"

#include <span>
#include <vector>

namespace tractus::variation {

// Influence of motion indicators on a plant, in units of the plant's height: an indicator as long
// as the plant is high has length 1, at whatever scale the plant is shown.
struct Influence {
    Vec3 everywhere = Vec3::Zero();
    std::vector<Vec3> local {}; // Per segment, besides; empty where there is none.

    bool is_none() const { return everywhere.isZero(0) && local.empty(); }
};

// How the plant stands in the drawing volume when the indicators are drawn.
struct ShownPlant {
    double height_mm = 0; // Above 0.
    double scale = 1;     // World millimetres per plant millimetre; above 0.
};

// The dominant influence on growth: the indicators added as vectors, those that act everywhere once
// and for all, the others segment by segment. Where a segment is counts in the plant before it
// grows: `nodes_mm`, the nodes of `plant` as place_nodes gives them, plant frame.
//
// Refuses, in a sentence, what check_indicator refuses, and a height or scale that is not above 0.
Result<Influence> influence_of(Plant const& plant, std::span<Vec3 const> nodes_mm,
                               std::span<MotionIndicator const> indicators,
                               ShownPlant const& shown);

} // namespace tractus::variation
