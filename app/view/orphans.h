#pragma once

#include "app/view/window_model.h"
#include "engine/scene/scene.h"

#include <vector>

namespace tractus::view {

// Returns the strokes and indicators of a scene whose branch no longer exists, in order.
std::vector<OrphanView> orphans_of(scene::Scene const& scene);

// Returns the edits that remove all orphans (see orphans_of()) of a scene.
std::vector<scene::Edit> edits_without_orphans(scene::Scene const& scene);

} // namespace tractus::view
