#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/fields.h"

#include <cstddef>
#include <string>

namespace tractus::lines {

// Functions shared by the edits of sketches.

// Index of a plant, and its sketch.
struct FoundSketch {
    std::size_t number = 0;
    PenSketch sketch;
};

// Finds the sketch of a plant. Fails with a user error if there is no such plant, or if it is not
// drawn with construction lines.
Result<FoundSketch> find_sketch(scene::DocumentState const& state, scene::ItemId plant);

// Replaces the sketch of a plant. If the first stem has changed, the plant is moved to its foot, so
// that all lines stay in place.
void put_sketch(scene::DocumentState& state, FoundSketch found);

// Returns the line that owns a layer. Fails with a user error if there is none.
Result<SketchLine*> find_layer(PenSketch& sketch, scene::ItemId line);

// Position on the tablet at which the pen came down to draw a line.
Vec2 begin_on_tablet(SketchLine const& line);

// Position of the foot of the first stem on the sheet.
Vec2 foot_on_sheet(PenSketch const& sketch);

void list(scene::Fields& fields, Pattern& pattern);

// Checks a pattern. Fails with a user error if a number is out of range.
Result<void> check_pattern(Pattern const& pattern);

std::string describe(Pattern const& pattern);

} // namespace tractus::lines
