#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <optional>

namespace tractus::scene {

// Sets the rules of a plant's model whose numbers come from a drawing
// (PlantSource::accepts_rules()). Items drawn on the plant's branches are kept.
struct WriteRules {
    static EditKind const kKind;

    ItemId plant = 0;
    SourceRules rules {}; // With an empty text: the model's own rules.
};

} // namespace tractus::scene
