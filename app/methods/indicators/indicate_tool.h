#pragma once

#include "app/tools/tool.h"
#include "engine/variation/motion_indicator.h"

namespace tractus::indicators {

// The stroke's two ends are a motion indicator.
struct IndicateTool {
    static tools::ToolKind const kKind;

    enum class Reach {
        Everywhere,
        Below, // The selected branches and what they bear.
        Near,  // Falling off around the stroke.
    };
    Reach reach = Reach::Everywhere;
    variation::MotionIndicator::Kind indicator = variation::MotionIndicator::Kind::Push;
};

} // namespace tractus::indicators
