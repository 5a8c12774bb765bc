#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"
#include "engine/variation/motion_indicator.h"

#include <cstddef>

namespace tractus::indicators {

// The indicator that passes near the place where a stroke begins.
struct TouchedIndicator {
    std::size_t number = 0;         // Number of the scene's indicator.
    variation::MotionIndicator way; // Way from where the stroke begins to where it ends.
};

// Fails, as the user's fault, if there is none.
Result<TouchedIndicator> touched_indicator(Stroke const& stroke, scene::Scene const& scene);

} // namespace tractus::indicators
