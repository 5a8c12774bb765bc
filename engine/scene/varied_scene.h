#pragma once

#include "engine/base/result.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth_noise.h"

#include <optional>

namespace tractus::scene {

// True if any plant of the scene, or a part of one, has a source that can vary (SourceKind::vary).
bool has_sources_that_vary(Scene const& scene);

// Returns the scene with the source of each plant and each part varied. Items drawn on branches
// stay on those branches that still exist; the others become orphans.
//
// Fails if a varied plant cannot be built.
Result<Scene> varied(Scene const& scene, SourceVariation const& variation);

// Decides which plants of a collection have a seed of their own for their models' stochastic rules,
// and derives these plants.
class SeedAssignment {
public:
    SeedAssignment() = default; // No plant has a seed of its own.

    // `share` as in Individuality::seeds. Without stochastic rules in the scene no plant has its
    // own seed.
    SeedAssignment(Scene const& scene, double share);

    // True if the plant of `key` is derived by a seed of its own.
    bool has(variation::PlantKey const& key) const;

    // Returns the scene of the plant of `key`: with_own_seed(), or `scene` itself.
    Scene scene_of(Scene const& scene, variation::PlantKey const& key) const;

private:
    double share_ = 0;
};

// Returns the scene with its active plant only; unchanged if it has fewer than two plants.
Scene active_plant_alone(Scene const& scene);

// Returns another individual for one plant of a collection: the scene with each model from a file
// derived by a seed of its own. Strokes lie on the branches that are most similar to those they
// were drawn on (variation/similar_branches.h). Several seeds are tried until these branches are
// similar enough; if with every seed a stroke, limb or graft lacks a branch, the scene itself is
// returned.
Scene with_own_seed(Scene const& scene, std::uint64_t seed, std::uint32_t plant);

// True if with_own_seed() can return another scene: a model from a file has stochastic rules.
bool has_stochastic_models(Scene const& scene);

} // namespace tractus::scene
