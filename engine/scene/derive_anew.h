#pragma once

#include "engine/plant/branch_address.h"
#include "engine/scene/anchored.h"
#include "engine/scene/edit_kind.h"
#include "engine/variation/growth_noise.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::scene {

struct Scene;

// Derives a plant's models by other seeds for their stochastic rules, and moves its strokes to the
// branches that the plant then has. It is how a plant of a collection becomes the plant itself.
struct DeriveAnew {
    static EditKind const kKind;

    ItemId plant = 0;
    // Seeds of the plant's source and of its grafts' sources, in their order; used for models from
    // a file, and ignored for other sources.
    std::vector<std::uint64_t> seeds {};
    std::vector<std::uint64_t> strokes {}; // Ids of the strokes that move.
    std::vector<PathAddress> at {};        // Where each of them is then.
};

// Returns the edit that derives the active plant as SeedAssignment (varied_scene.h) does for the
// plant of `key`, if that were the only one of the document; no value if its segments stay. `share`
// as in Individuality::seeds.
std::optional<DeriveAnew> derive_anew(Scene const& scene, variation::PlantKey const& key,
                                      double share);

} // namespace tractus::scene
