#pragma once

#include "app/tools/tool.h"
#include "engine/methods/leaves/leaf_sketch.h"

namespace tractus::leaf {

// A stroke is a line of a leaf, on paper: its outline, midrib or a vein, which are told apart by
// how they lie. The leaf follows each of them. Numbers change the leaf that takes what is drawn.
struct LeafLineTool {
    static tools::ToolKind const kKind;

    enum class Plant {
        GoOn,    // With the active plant if that is a leaf, else with another one.
        NewLeaf, // Always with another one.
    };
    Plant plant = Plant::GoOn;
    // As of leaf::LeafForm.
    double bend_deg = 0;
    double rise_deg = 0;
    double vein_curve_deg = 0;
    double vein_width = 1;
    double teeth = 0;
    double tooth_depth = 0.02;
    double variation = 1;
};

} // namespace tractus::leaf
