#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Sets how many nodes a layer of the active plant's sketch has. A layer is the part of the stem
// between two inclination lines.
struct LayerNodesTool {
    static tools::ToolKind const kKind;

    enum class What {
        Touched, // The layer beside which the stroke ends gets `nodes` nodes.
        More,    // Adds a node to the topmost layer.
        Fewer,   // Removes a node from the topmost layer.
    };
    What what = What::Touched;
    double nodes = 8;
};

} // namespace tractus::lines
