#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

namespace tractus::scene {

// Derives and interprets the model of a LoadModel edit; also used by methods that generate models.
// Fails if the model does not compile or derive, or exceeds its limits.
Result<BuiltSource> build_lsystem(LoadModel const& model, LoadOptions const& options);

} // namespace tractus::scene
