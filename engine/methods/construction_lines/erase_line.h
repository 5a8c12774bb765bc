#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

namespace tractus::lines {

// Edit: deletes a line of a sketch, or a line of one of its drawn leaves.
struct EraseLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// Returns the sketch without a line. A stem is deleted together with its lines and the stems
// attached to it. A leaf of which no side is left is deleted and replaced by plain leaves. Fails
// with a user error if there is no such line, if it is the only stem, or if the remaining lines
// give no plant.
Result<PenSketch> without_line(PenSketch sketch, scene::ItemId line);

} // namespace tractus::lines
