#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/stroke/stroke.h"

#include <span>

namespace tractus {

// A line drawn in space that says where an influence pushes, and by its length how much: wind is
// drawn sideways, sunlight upwards, rain downwards (Streit 2006 section 4.4). World frame.
struct MotionIndicator {
    Vec3 start_mm = Vec3::Zero();
    Vec3 end_mm = Vec3::Zero();
};

// Only the ends of the drawn stroke count. Refuses, in a sentence, a stroke without tips or with an
// end that is not finite. A stroke that ends where it began pushes nowhere, and is fine.
Result<MotionIndicator> motion_indicator(Stroke const& stroke);

// The dominant influence on growth: all indicators added as vectors, in units of the plant's
// height. `shown_height_mm` is the height at which the plant stands in the drawing volume, above 0:
// an indicator as long as the plant is high has length 1, at whatever scale the plant is shown.
Vec3 summed_influence(std::span<MotionIndicator const> indicators, double shown_height_mm);

} // namespace tractus
