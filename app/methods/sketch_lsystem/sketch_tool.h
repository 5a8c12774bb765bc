#pragma once

#include "app/tools/tool.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"

namespace tractus {

// A rule grows along the stroke: a new plant (Ijiri, Owada, Igarashi 2006).
struct SketchTool {
    static ToolKind const kKind;

    // Numbers of the rule; all else of it is as usual, the twist such that rings of laterals
    // alternate.
    double laterals = 2;
    double angle_deg = 45;
    double first_length_mm = 30;
    double length_ratio = 0.9;
    double lateral_length = 0.62;
    sketch::Leaves leaves = sketch::Leaves::Leafy;
    StrokeSurface surface = StrokeSurface::Decided;
};

// Returns what a stroke with the tool means: the tips drawn so far, in a document as it is built.
sketch::GrowAlongStroke grown_along(SketchTool const& tool, Stroke const& stroke,
                                    Scene const& scene);

} // namespace tractus
