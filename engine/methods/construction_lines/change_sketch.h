#pragma once

#include "engine/methods/construction_lines/pen_sketch.h"
#include "engine/scene/document_state.h"
#include "engine/scene/fields.h"

#include <cstddef>
#include <string>

namespace tractus::lines {

// What edits of sketches have in common.

// A plant by its number, and its sketch.
struct FoundSketch {
    std::size_t number = 0;
    PenSketch sketch;
};

// Fails, as the user's fault, for a plant that is not there, or is not drawn with lines.
Result<FoundSketch> find_sketch(scene::DocumentState const& state, scene::ItemId plant);

// Puts another sketch in the place of a plant's. Where it has another stem the plant stands at that
// one's foot, and so all of its lines stay where they are.
void put_sketch(scene::DocumentState& state, FoundSketch found);

// The line whose layer this is. Fails, as the user's fault, where there is none.
Result<SketchLine*> find_layer(PenSketch& sketch, scene::ItemId line);

// Where the pen came down for a line, on the tablet then.
Vec2 begin_on_tablet(SketchLine const& line);

// Where the foot of the first stem is.
Vec2 foot_on_sheet(PenSketch const& sketch);

void list(scene::Fields& fields, Pattern& pattern);

// Fails, as the user's fault, for numbers out of their range.
Result<void> check_pattern(Pattern const& pattern);

std::string describe(Pattern const& pattern);

} // namespace tractus::lines
