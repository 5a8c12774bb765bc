#pragma once

#include "engine/scene/document_state.h"
#include "engine/scene/scene_builder.h"

#include <memory>
#include <vector>

namespace tractus::scene {

// Whether a plant is more than its own source: parts were put on it, or branches are hidden.
bool is_composed(PlantState const& plant);

// Puts the base plant of a document's plant together: its own source's, then each part on its
// branch, without what is hidden. A part whose branch is not there waits, which a warning says.
// `parts` are the base plants of plant.grafts, in their order.
std::shared_ptr<BasePlant const>
compose_base(PlantState const& plant, std::shared_ptr<BasePlant const> const& own,
             std::vector<std::shared_ptr<BasePlant const>> const& parts);

} // namespace tractus::scene
