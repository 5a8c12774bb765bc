#pragma once

#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::sketch {

// Edits of a plant, or of a grafted part of a plant, that grew along a stroke. Strokes on its
// branches stay at the same places on these branches. `part` is 0 for the plant itself.

// Edit: grows another rule, or another model, along the same stroke.
struct ChangeSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    Rule rule {};
    Leaves leaves = Leaves::Leafy;
    // Model that grows instead of the rule, if it is set (GrowAlongStroke::model).
    ModelRule model {};
};

// Edit: shortens the stroke at its end, together with what has grown along it.
struct ShortenSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    std::uint64_t tips = 0; // Number of tip samples to keep, from the beginning of the stroke.
};

// Edit: replaces the stroke. A plant moves to the beginning of the new stroke; a grafted part stays
// on its branch.
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

// The newest part of a plant that grew along a stroke, or the plant itself; no value if neither
// did.
std::optional<GrownPart> newest_grown(scene::PlantState const& plant);

// Number of the stroke's tip samples that are needed for `segments` segments; no value if the whole
// stroke is too short for so many.
Result<std::optional<std::size_t>> count_tips(GrowAlongStroke const& sketch, std::size_t segments);

} // namespace tractus::sketch
