#pragma once

#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::sketch {

// The edits of this file change a plant, or a grafted part of a plant, that grew along a stroke.
// Strokes on its branches stay at the same places on these branches. The field `part` is the id of
// the grafted part; 0: the plant itself.

// Edit: replaces the rule or model that grew along a stroke. The stroke stays the same.
struct ChangeSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    Rule rule {};
    Leaves leaves = Leaves::Leafy;
    // Model that grows instead of the rule, if it is set (GrowAlongStroke::model).
    ModelRule model {};
};

// Edit: cuts off the end of a stroke along which a plant or a grafted part grew, together with what
// grew there.
struct ShortenSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    std::uint64_t tips = 0; // Number of tip samples to keep, from the beginning of the stroke.
};

// Edit: replaces the stroke along which a plant or a grafted part grew. A plant moves to the
// beginning of the new stroke; a grafted part stays on its branch.
struct RedrawSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    // Surface on which the stroke was drawn; must not be Decided.
    StrokeSurface surface = StrokeSurface::Space;
    Stroke stroke {}; // The new stroke, world frame.
    // True if the stroke is the reverse of what was drawn (GrowAlongStroke::is_drawn_reversed).
    bool is_drawn_reversed = false;
};

// A plant or grafted part that grew along a stroke.
struct GrownPart {
    scene::ItemId part = 0; // Id of the grafted part; 0: the plant itself.
    // The edit that grew the part; valid as long as the plant's state exists.
    GrowAlongStroke const* sketch = nullptr;
};

// All parts of a plant that grew along strokes, newest first; the plant itself comes last.
std::vector<GrownPart> all_grown(scene::PlantState const& plant);

// The newest grafted part of a plant that grew along a stroke; if there is none, the plant itself.
// No value if the plant did not grow along a stroke either.
std::optional<GrownPart> newest_grown(scene::PlantState const& plant);

// Number of tip samples, from the beginning of the stroke, that are needed for an axis of
// `segments` segments; no value if the whole stroke is too short.
Result<std::optional<std::size_t>> count_tips(GrowAlongStroke const& sketch, std::size_t segments);

} // namespace tractus::sketch
