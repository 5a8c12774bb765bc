#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Sets how many nodes a layer of the active plant's sketch has.
struct LayerNodesTool {
    static tools::ToolKind const kKind;

    enum class What {
        Touched, // The layer beside which the stroke ends gets so many.
        More,    // The topmost layer gets one more,
        Fewer,   // or one fewer.
    };
    What what = What::Touched;
    double nodes = 8;
};

} // namespace tractus::lines
