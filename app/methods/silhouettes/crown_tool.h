#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

#include <memory>

namespace tractus::silhouette {

// Draws a tree's crown in space by lines of three kinds: rings around the trunk at several heights,
// a line that winds around the trunk while climbing, and outlines in vertical planes
// (drawn_surface.h). Branches are inferred from the crown after Wither, Boudon, Cani, Godin 2009.
struct CrownTool {
    static tools::ToolKind const kKind;

    enum class What {
        // Adds the line to the active tree's crown if the line goes around the tree's trunk;
        // otherwise begins a new tree.
        GoOn,
        New, // Always begins a new tree.
    } what
        = What::GoOn;

    NodesOption nodes = NodesOption::Whole;
    FillsOption fills = FillsOption::BySpacing;
};

// Interprets a stroke of the tool. Fails with a user error if the stroke is neither a ring nor a
// climbing line nor an outline in a vertical plane (kind_of() in crown_line.h).
Result<silhouette::DrawTree> drawn_crown(CrownTool const& tool, Stroke const& stroke,
                                         scene::Scene const& scene);

// Converts a stroke in space to the coordinates of a sheet: x and y on the sheet, and z behind it.
Stroke on_sheet(Stroke stroke, scene::Paper const& paper);

std::unique_ptr<tools::StrokePreviewer> crown_previewer();

} // namespace tractus::silhouette
