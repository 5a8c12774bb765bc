#pragma once

#include "app/view/window_model.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::view {

// The strokes and indicators of a scene whose branch no longer exists, in order.
std::vector<OrphanView> orphans_of(scene::Scene const& scene);

// The edits that remove all orphans of a scene.
std::vector<scene::Edit> edits_without_orphans(scene::Scene const& scene);

} // namespace tractus::view
