#pragma once

#include "engine/base/result.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/scene.h"

namespace tractus::scene {

// Whether any plant of the scene, or a part of one, can vary what it was drawn as
// (SourceKind::vary).
bool has_sources_that_vary(Scene const& scene);

// The scene in which each plant and each part is another of its kind. What was drawn on branches
// stays on those that there are; strokes of others wait.
//
// Fails where a varied plant cannot be built.
Result<Scene> varied(Scene const& scene, SourceVariation const& variation);

} // namespace tractus::scene
