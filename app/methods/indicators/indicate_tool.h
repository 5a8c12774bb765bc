#pragma once

#include "app/tools/tool.h"
#include "engine/variation/motion_indicator.h"

namespace tractus::indicators {

// Makes a motion indicator, an arrow that bends branches, from the stroke's start to its end.
struct IndicateTool {
    static tools::ToolKind const kKind;

    enum class Reach {
        Everywhere,
        Below, // Affects the selected branches and their descendants.
        Near,  // Affects branches near the indicator, less so with distance.
    };
    Reach reach = Reach::Everywhere;
    variation::MotionIndicator::Kind indicator = variation::MotionIndicator::Kind::Push;
};

} // namespace tractus::indicators
