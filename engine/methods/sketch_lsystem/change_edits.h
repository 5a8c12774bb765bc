#pragma once

#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/scene/document_state.h"
#include "engine/scene/edit.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::sketch {

// Edits of what has grown along a stroke already. What was drawn on its branches stays where they
// stay. They name a plant, and, where it is a part that was put on that plant, the part; 0: it is
// the plant itself.

// Lets another rule, or another model, grow along the same stroke.
struct ChangeSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    Rule rule {};
    Leaves leaves = Leaves::Leafy;
    ModelRule model {}; // As of GrowAlongStroke.
};

// Takes the end of the stroke away, and what the rule has grown along it.
struct ShortenSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    std::uint64_t tips = 0; // How many of the stroke's stay, from its beginning.
};

// Lets the rule grow along another stroke. A plant stands where that begins then; a part stays on
// its branch.
struct RedrawSketch {
    static scene::EditKind const kKind;

    scene::ItemId plant = 0;
    scene::ItemId part = 0;
    StrokeSurface surface = StrokeSurface::Space; // Never Decided.
    Stroke stroke {};                             // World frame.
};

// Something that has grown along a stroke.
struct GrownPart {
    scene::ItemId part = 0;                  // As in the edits.
    GrowAlongStroke const* sketch = nullptr; // As long as the plant's state is there.
};

// All of a plant that has grown so, the newest part first and the plant itself last.
std::vector<GrownPart> all_grown(scene::PlantState const& plant);

// What has grown of a plant last: the newest part that has, or else the plant itself. No value: it
// has not.
std::optional<GrownPart> newest_grown(scene::PlantState const& plant);

// How many of the stroke's tips it takes to make so many segments; no value: it makes fewer.
Result<std::optional<std::size_t>> count_tips(GrowAlongStroke const& sketch, std::size_t segments);

} // namespace tractus::sketch
