#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/scene.h"

namespace tractus::lines {

// The construction lines of the active plant, and where they are.
struct ActiveSketch {
    scene::ItemId plant = 0;
    lines::PenSketch sketch;
    lines::SheetPlacement sheet; // Where the sketch's sheet is on the tablet.
};

// Returns the sketch of the active plant. Fails with a user error if the active plant was not drawn
// with construction lines.
Result<ActiveSketch> active_sketch(scene::Scene const& scene);

// Returns the place on the sketch's sheet where the stroke ended.
Vec2 touched_mm(ActiveSketch const& active, Stroke const& stroke);

} // namespace tractus::lines
