#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <optional>

namespace tractus::scene {

// Writes the rules of a plant's model whose numbers are drawn (PlantSource::can_take_rules()). What
// was drawn on the plant's branches stays.
struct WriteRules {
    static EditKind const kKind;

    ItemId plant = 0;
    SourceRules rules {}; // Without a text: those that it had of itself.
};

} // namespace tractus::scene
