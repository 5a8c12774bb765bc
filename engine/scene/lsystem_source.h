#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

namespace tractus::scene {

// Derives and interprets a model, as the edit that loads it says: what methods whose plants are
// models build them with. Fails for a model that does not compile or derive, or not within its
// limits.
Result<BuiltSource> build_lsystem(LoadModel const& model, LoadOptions const& options);

} // namespace tractus::scene
