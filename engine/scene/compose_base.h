#pragma once

#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <memory>
#include <vector>

namespace tractus::scene {

// True if the plant differs from what its source gives: it has added parts or hidden branches.
bool is_composed(PlantState const& plant);

// Composes the base plant of a document's plant from `own`, the base plant of its own source:
// attaches the plant's parts to their branches and removes hidden branches. A part whose branch
// does not exist is left out, with a warning. `parts`: the base plants of plant.grafts, in the same
// order; null for drawn limbs, whose base plants are made here.
std::shared_ptr<BasePlant const>
compose_base(PlantState const& plant, std::shared_ptr<BasePlant const> const& own,
             std::vector<std::shared_ptr<BasePlant const>> const& parts);

} // namespace tractus::scene
