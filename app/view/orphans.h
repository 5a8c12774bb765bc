#pragma once

#include "app/view/window_model.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::view {

// The strokes and indicators of a scene whose branch its plant has lost, in order.
std::vector<OrphanView> orphans_of(scene::Scene const& scene);

// What takes them away.
std::vector<scene::Edit> edits_without_orphans(scene::Scene const& scene);

} // namespace tractus::view
