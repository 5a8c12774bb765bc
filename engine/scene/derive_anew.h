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

// Derives a plant's models again with other seeds of their stochastic rules, and moves strokes to
// the branches of the new individual. In this way a plant of a collection replaces the drawn plant.
struct DeriveAnew {
    static EditKind const kKind;

    ItemId plant = 0;
    // Seeds of the plant's source and then of its grafts' sources. Only models from a file use
    // them.
    std::vector<std::uint64_t> seeds {};
    std::vector<std::uint64_t> strokes {}; // Ids of the strokes that move.
    std::vector<PathAddress> at {};        // New paths of these strokes, in the same order.
};

// Returns the edit that gives the active plant the seeds that the plant of `key` has by
// SeedAssignment (varied_scene.h) if the active plant is the only one of the document. No value if
// the plant of `key` has no seed of its own, and if nothing would change. `share` as in
// Individuality::seeds.
std::optional<DeriveAnew> derive_anew(Scene const& scene, variation::PlantKey const& key,
                                      double share);

} // namespace tractus::scene
