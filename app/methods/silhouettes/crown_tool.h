#pragma once

#include "app/methods/silhouettes/nodes_option.h"
#include "app/tools/tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

#include <memory>

namespace tractus::silhouette {

// Draws a tree's crown in space: rings around its trunk at several heights, one line that winds
// around it as it climbs, or outlines in upright planes (drawn_surface.h, Wither, Boudon, Cani,
// Godin 2009 for what follows from that).
struct CrownTool {
    static tools::ToolKind const kKind;

    enum class What {
        GoOn, // It is the active tree's crown if that has a trunk in it, else a new tree's.
        New,  // It is a new tree's.
    } what
        = What::GoOn;

    NodesOption nodes = NodesOption::Whole;
};

// What a stroke with the tool draws. Fails, as the user's fault, like kind_of() (crown_line.h).
Result<silhouette::DrawTree> drawn_crown(CrownTool const& tool, Stroke const& stroke,
                                         scene::Scene const& scene);

// A stroke in space with x and y on a sheet, and z how far behind it each place is.
Stroke on_sheet(Stroke stroke, scene::Paper const& paper);

std::unique_ptr<tools::StrokePreviewer> crown_previewer();

} // namespace tractus::silhouette
