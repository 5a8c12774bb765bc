#pragma once

#include "engine/scene/edit.h"
#include "engine/scene/plant_source.h"

#include <cstdint>
#include <optional>

namespace tractus::scene {

// Derives and interprets the model of a LoadModel edit. Methods that generate models also use this.
// Fails if the model does not compile or derive, or exceeds its limits.
Result<BuiltSource> build_lsystem(LoadModel const& model, LoadOptions const& options);

// Returns the source with `seed` for the stochastic rules of its model. Returns no value unless the
// source is a model from a file.
std::optional<PlantSource> with_model_seed(PlantSource const& source, std::uint64_t seed);

} // namespace tractus::scene
