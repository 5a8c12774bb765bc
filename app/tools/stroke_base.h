#pragma once

#include "app/tools/tool.h"

#include <span>
#include <string>

namespace tractus::tools {

// The end of a stroke that is laid on the base of a branch.
enum class StrokeBase {
    // The stroke's beginning. Logs that are older than this option lack it and mean this.
    AsDrawn,
    // The stroke's foot: a stroke that was drawn from the branch's tip to its base is reversed.
    AtFoot,
};

// Visits the option StrokeBase, which has no button.
void visit_base(OptionVisitor& visitor, StrokeBase& base);

// A stroke from foot to tip.
struct StrokeFromFoot {
    Stroke stroke {};
    bool is_drawn_reversed = false; // True if it was drawn from tip to foot.
};

// The stroke as it is laid on a branch of the active plant, given by its segments from base to tip.
// With StrokeBase::AtFoot the stroke is reversed if it ends at the branch's base, where the view
// shows it, and begins nearer to its tip; and also, for a trunk, if it runs down to the ground on
// which the plant stands.
StrokeFromFoot from_foot(StrokeBase base, Stroke const& stroke, std::span<SegmentId const> branch,
                         scene::Scene const& scene);

// ToolKind::describe for tools whose strokes bend branches. If the last edit has reversed a stroke,
// says so and how to reverse it again; otherwise like underground_message().
std::string bent_branch_message(Tool const& tool, scene::Scene const& after);

} // namespace tractus::tools
