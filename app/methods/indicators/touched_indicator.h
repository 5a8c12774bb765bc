#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/motion_indicator.h"

#include <cstddef>

namespace tractus::indicators {

// The motion indicator that passes near the start of a stroke.
struct TouchedIndicator {
    std::size_t number = 0;         // Index in the scene's indicators.
    variation::MotionIndicator way; // Vector from the start of the stroke to its end.
};

// Fails with a user error if no indicator is near.
Result<TouchedIndicator> touched_indicator(Stroke const& stroke, scene::Scene const& scene);

} // namespace tractus::indicators
