#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <optional>

namespace tractus::scene {

// Replaces the rules of the model that is made from a plant's drawing
// (PlantSource::accepts_rules()). Items drawn on the plant's branches are kept.
struct WriteRules {
    static EditKind const kKind;

    ItemId plant = 0;
    SourceRules rules {}; // The new rules; if the text is empty, the model's own apply.
};

} // namespace tractus::scene
