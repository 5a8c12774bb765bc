#pragma once

#include "engine/base/result.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/scene.h"

namespace tractus::scene {

// True if any plant of the scene, or a part of one, has a source that can vary (SourceKind::vary).
bool has_sources_that_vary(Scene const& scene);

// Returns the scene with the source of each plant and each part varied. Items drawn on branches
// stay on those branches that still exist; the others become orphans.
//
// Fails if a varied plant cannot be built.
Result<Scene> varied(Scene const& scene, SourceVariation const& variation);

} // namespace tractus::scene
