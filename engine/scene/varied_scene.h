#pragma once

#include "engine/base/result.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth_noise.h"

#include <optional>

namespace tractus::scene {

// True if any plant of the scene, or a part of one, has a source that can vary
// (PlantSource::can_vary()).
bool has_sources_that_vary(Scene const& scene);

// Returns the scene with the sources of all plants and parts varied. Items drawn on branches stay
// on those branches that still exist; the other items become orphans.
//
// Fails if a varied plant cannot be built.
Result<Scene> varied(Scene const& scene, SourceVariation const& variation);

// Decides which plants of a collection have a seed of their own for the stochastic rules of their
// models, and derives those plants.
class SeedAssignment {
public:
    SeedAssignment() = default; // Gives no plant a seed of its own.

    // `share`: share of the plants that have a seed of their own (Individuality::seeds). If no
    // model of the scene has stochastic rules, no plant has its own seed.
    SeedAssignment(Scene const& scene, double share);

    // True if the plant with this key has a seed of its own.
    bool has(variation::PlantKey const& key) const;

    // Returns the scene that shows the plant with this key: with_own_seed(), or `scene` itself if
    // the plant has no seed of its own.
    Scene scene_of(Scene const& scene, variation::PlantKey const& key) const;

private:
    double share_ = 0;
};

// Returns the scene with only its active plant; unchanged if it has fewer than two plants.
Scene active_plant_alone(Scene const& scene);

// Returns another individual for one plant of a collection: the scene with each model from a file
// derived by a new seed. Strokes move to the branches most similar to those that they were drawn on
// (variation/similar_branches.h). Several seeds are tried until these branches are similar enough.
// If with every seed some stroke, limb or graft lacks a branch, `scene` is returned unchanged.
Scene with_own_seed(Scene const& scene, std::uint64_t seed, std::uint32_t plant);

// True if another seed changes the scene: it has a model from a file with stochastic rules.
bool has_stochastic_models(Scene const& scene);

} // namespace tractus::scene
