#pragma once

#include "app/tools/tool.h"
#include "engine/methods/construction_lines/sketch_organ.h"

namespace tractus::lines {

// A stroke is a line of a leaf of the active plant, which is drawn in three views (2008, section
// 6): from above, from the side and from the front.
struct LineOrganTool {
    static tools::ToolKind const kKind;

    enum class What {
        Edge,    // From above, from its base to its tip; the first begins a leaf.
        Midrib,  // From the side.
        Section, // From the front.
        Another, // An edge that begins another leaf.
    };
    What what = What::Edge;
    lines::OrganColor color = lines::OrganColor::Leaf;
};

} // namespace tractus::lines
