#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

#include <memory>

namespace tractus::silhouette {

// Draws a tree's crown in space by one of three kinds of lines: rings around its trunk at several
// heights, one line that winds around it while climbing, or outlines in vertical planes
// (drawn_surface.h). Branches are inferred from the crown after Wither, Boudon, Cani, Godin 2009.
struct CrownTool {
    static tools::ToolKind const kKind;

    enum class What {
        // Adds to the active tree's crown if its trunk is inside the line, otherwise begins a new
        // tree.
        GoOn,
        New, // Always begins a new tree.
    } what
        = What::GoOn;

    NodesOption nodes = NodesOption::Whole;
    FillsOption fills = FillsOption::BySpacing;
};

// Interprets a stroke of the tool. Fails with a user error like kind_of() (crown_line.h).
Result<silhouette::DrawTree> drawn_crown(CrownTool const& tool, Stroke const& stroke,
                                         scene::Scene const& scene);

// Converts a stroke in space to sheet coordinates: x and y on the sheet, z the distance behind it.
Stroke on_sheet(Stroke stroke, scene::Paper const& paper);

std::unique_ptr<tools::StrokePreviewer> crown_previewer();

} // namespace tractus::silhouette
