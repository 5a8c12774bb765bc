#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/fields.h"

#include <cstddef>
#include <string>

namespace tractus::lines {

// Functions shared by the edits of plants that are drawn with construction lines.

// The sketch of a plant, and the index of the plant in the document.
struct FoundSketch {
    std::size_t number = 0;
    PenSketch sketch;
};

// Finds the sketch of a plant. Fails with a user error if there is no such plant, or if the plant
// is not drawn with construction lines.
Result<FoundSketch> find_sketch(scene::DocumentState const& state, scene::ItemId plant);

// Replaces the sketch of a plant. If another stroke has become the first stem, or if lines are
// interpreted together, the plant is moved to the foot of the first stem, so that all lines stay in
// place.
void put_sketch(scene::DocumentState& state, FoundSketch found);

// Returns the line with this id, which owns a layer (see Layer). Fails with a user error if there
// is no such line.
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
