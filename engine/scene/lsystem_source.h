#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <cstdint>
#include <optional>

namespace tractus::scene {

// Derives and interprets the model of a LoadModel edit; also used by methods that generate models.
// Fails if the model does not compile or derive, or exceeds its limits.
Result<BuiltSource> build_lsystem(LoadModel const& model, LoadOptions const& options);

// Returns the source with `seed` for its model's stochastic rules, if it is a model from a file; no
// value for other sources.
std::optional<PlantSource> with_model_seed(PlantSource const& source, std::uint64_t seed);

} // namespace tractus::scene
