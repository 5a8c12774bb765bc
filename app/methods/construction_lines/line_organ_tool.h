#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/sketch_organ.h"

namespace tractus::lines {

// Draws the lines of the active plant's leaves in three views: from above, from the side, and from
// the leaf's tip (Anastacio, Prusinkiewicz, Sousa 2008, section 6).
struct LineOrganTool {
    static tools::ToolKind const kKind;

    enum class What {
        // An edge of the leaf, seen from above, from base to tip. The first edge begins a leaf.
        Edge,
        Midrib,  // The midrib, seen from the side.
        Section, // The cross section, seen from the leaf's tip.
        Another, // An edge that begins another kind of leaf.
    };
    What what = What::Edge;
    lines::OrganColor color = lines::OrganColor::Leaf;
};

} // namespace tractus::lines
