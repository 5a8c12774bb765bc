#pragma once

#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <memory>
#include <vector>

namespace tractus::scene {

// True if a plant consists of more than the plant of its source, or less: parts were grafted onto
// it, or branches are hidden.
bool is_composed(PlantState const& plant);

// Composes the base plant of a document's plant: the plant of its own source, with each part on its
// branch, without what is hidden. A part whose branch does not exist is left out, with a warning.
// `parts`: the base plants of plant.grafts, in the same order; null for drawn limbs, which are made
// here.
std::shared_ptr<BasePlant const>
compose_base(PlantState const& plant, std::shared_ptr<BasePlant const> const& own,
             std::vector<std::shared_ptr<BasePlant const>> const& parts);

} // namespace tractus::scene
