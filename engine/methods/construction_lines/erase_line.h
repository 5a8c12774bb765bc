#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/edit.h"

namespace tractus::lines {

// Takes a line of a sketch away, or one of a leaf of its own.
struct EraseLine {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId line = 0;
};

// The sketch without a line. With a stem go its lines, and the stems that stand on it; with the
// last side of a leaf goes the leaf, in whose place there are plain leaves then. Fails, as the
// user's fault, for a line that is not there, for the only stem, and if the rest gives no plant.
Result<PenSketch> without_line(PenSketch sketch, scene::ItemId line);

} // namespace tractus::lines
