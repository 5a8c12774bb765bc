#pragma once

#include "app/tools/stroke_base.h"
#include "app/tools/tool.h"
#include "engine/scene/limb_edits.h"

namespace tractus::tools {

// Turns a stroke that begins on a branch, or in the air near one, into a new limb of the plant.
struct LimbTool {
    static ToolKind const kKind;

    enum class Does {
        Draw,
        Erase, // Erases the touched limb, if it was drawn with this tool.
    } does
        = Does::Draw;
    double thickness = 1; // Thickness of the limb as a multiple of the ink's width.
    // With StrokeBase::AtFoot, a stroke that begins in the air and ends on a branch is reversed.
    StrokeBase base = StrokeBase::AtFoot;
};

// Returns the limb that a stroke draws. It is joined to the nearest branch of all visible plants,
// as bent by strokes, at the nearest point of the branch's axis, with its beginning or, if the
// stroke was drawn from its tip to a branch, with its end (LimbTool::base). Fails with a user error
// if no branch is within a quarter of its plant's height, or the stroke is empty.
Result<scene::DrawLimb> drawn_limb(LimbTool const& tool, Stroke const& stroke,
                                   scene::Scene const& scene);

} // namespace tractus::tools
