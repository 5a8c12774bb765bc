#pragma once

#include "app/tools/tool.h"

namespace tractus::lines {

// Sets the number of nodes in a layer of the active plant's sketch. A layer is the part of a stem
// between two neighbouring inclination lines.
struct LayerNodesTool {
    static tools::ToolKind const kKind;

    enum class What {
        Touched, // Gives `nodes` nodes to the layer beside which the stroke ends.
        More,    // Adds a node to the topmost layer.
        Fewer,   // Removes a node from the topmost layer.
    };
    What what = What::Touched;
    double nodes = 8;
};

} // namespace tractus::lines
