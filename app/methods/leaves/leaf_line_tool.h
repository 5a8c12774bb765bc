#pragma once

#include "app/tools/tool.h"
#include "engine/methods/leaves/leaf_sketch.h"

namespace tractus::leaf {

// Draws a leaf on paper. Each stroke is an outline, a midrib or a vein; which of them is recognised
// from its position. The leaf is updated after each stroke. The tool's numbers change the active
// leaf.
struct LeafLineTool {
    static tools::ToolKind const kKind;

    enum class Plant {
        GoOn,    // Continues the active plant if it is a drawn leaf, otherwise begins a new leaf.
        NewLeaf, // Always begins a new leaf.
    };
    Plant plant = Plant::GoOn;
    // Parameters with the meaning and units of leaf::LeafForm.
    double bend_deg = 0;
    double rise_deg = 0;
    double vein_curve_deg = 0;
    double vein_width = 1;
    double teeth = 0;
    double tooth_depth = 0.02;
    double variation = 1;
    // Whether several closed lines beside a line are the leaflets of a compound leaf. Logs that are
    // older than this option lack it and mean Simple.
    enum class Leaves { Simple, Compound } leaves = Leaves::Compound;
};

} // namespace tractus::leaf
