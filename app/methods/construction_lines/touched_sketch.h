#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/scene.h"

namespace tractus::lines {

// The sketch of the active plant.
struct ActiveSketch {
    scene::ItemId plant = 0;
    lines::PenSketch sketch;
    lines::SheetPlacement sheet; // Placement of the sketch's sheet on the tablet.
};

// Returns the active plant's sketch. Fails with a user error if that plant is not drawn with
// construction lines.
Result<ActiveSketch> active_sketch(scene::Scene const& scene);

// Place on the sheet where a stroke ended.
Vec2 touched_mm(ActiveSketch const& active, Stroke const& stroke);

} // namespace tractus::lines
