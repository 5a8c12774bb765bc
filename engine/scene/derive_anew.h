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
// the branches of the new individual. Used to replace the drawn plant by another individual of a
// collection.
struct DeriveAnew {
    static EditKind const kKind;

    ItemId plant = 0;
    // Seeds for the plant's source and then for the sources of its grafts, in order. A source that
    // is not a model from a file ignores its seed.
    std::vector<std::uint64_t> seeds {};
    std::vector<std::uint64_t> strokes {}; // Ids of the strokes to move.
    std::vector<PathAddress> at {};        // New paths of these strokes, in the same order.
};

// Returns the edit that turns the active plant into the individual that has `key` in a collection
// of this plant alone. Returns no value if there is no active plant, or if that individual has no
// seed of its own (SeedAssignment, varied_scene.h) or does not differ. `share`: share of the
// collection's plants with a seed of their own (Individuality::seeds).
std::optional<DeriveAnew> derive_anew(Scene const& scene, variation::PlantKey const& key,
                                      double share);

} // namespace tractus::scene
