#pragma once

#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <memory>
#include <vector>

namespace tractus::scene {

// True if a plant differs from the plant of its source: parts were added to it, or branches are
// hidden.
bool is_composed(PlantState const& plant);

// Composes the base plant of a document's plant: the plant of its own source, with parts attached
// to their branches and without hidden branches. A part whose branch does not exist is left out,
// with a warning. `parts`: the base plants of plant.grafts, in the same order; null for drawn
// limbs, which this function makes.
std::shared_ptr<BasePlant const>
compose_base(PlantState const& plant, std::shared_ptr<BasePlant const> const& own,
             std::vector<std::shared_ptr<BasePlant const>> const& parts);

} // namespace tractus::scene
