#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <optional>

namespace tractus::scene {

// Replaces the rules of the model that is generated from a plant's drawing, if
// PlantSource::accepts_rules(). Items drawn on the plant's branches are kept.
struct WriteRules {
    static EditKind const kKind;

    ItemId plant = 0;
    SourceRules rules {}; // The new rules; if the text is empty, the generated rules apply again.
};

} // namespace tractus::scene
