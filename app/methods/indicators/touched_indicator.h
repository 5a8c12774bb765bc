#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/motion_indicator.h"

#include <cstddef>

namespace tractus::indicators {

// A motion indicator that passes near the start of a stroke.
struct TouchedIndicator {
    std::size_t number = 0;         // Index of the indicator in the scene.
    variation::MotionIndicator way; // The vector from the stroke's start to its end.
};

// Finds the indicator nearest to the stroke's start. Fails with a user error if no indicator is
// within 25 mm.
Result<TouchedIndicator> touched_indicator(Stroke const& stroke, scene::Scene const& scene);

} // namespace tractus::indicators
