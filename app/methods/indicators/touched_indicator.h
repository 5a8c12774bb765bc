#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/motion_indicator.h"

#include <cstddef>

namespace tractus::indicators {

// The motion indicator that passes near the start of a stroke.
struct TouchedIndicator {
    std::size_t number = 0;         // Index of the touched indicator in the scene.
    variation::MotionIndicator way; // The stroke's vector, from start to end.
};

// Finds the indicator nearest to the stroke's start. Fails with a user error if none is near.
Result<TouchedIndicator> touched_indicator(Stroke const& stroke, scene::Scene const& scene);

} // namespace tractus::indicators
