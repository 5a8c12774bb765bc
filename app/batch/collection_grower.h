#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"

#include <cstddef>
#include <memory>

namespace tractus::batch {

// Grows the plants of a collection, one after the other: all from one plant, or each from another
// one of its kind (varied_scene.h).
class CollectionGrower {
public:
    // `construction` is SourceVariation::spread; at 0, and where nothing in the scene can vary so,
    // all plants have the drawn one's segments. Fails like plan_growth().
    static Result<CollectionGrower> create(scene::Scene scene, double construction);

    // Whether all plants have the same segments.
    bool has_one_topology() const { return construction_ == 0; }

    // The plant as drawn, and that of a key. Hold until the next call.
    Result<Plant> drawn() const;
    Plant const& grow(variation::PlantKey const& key, double age = 1);

    // How many plants could not be varied so, and are as drawn but for their growth.
    std::size_t failed_count() const { return failed_count_; }

private:
    // A scene and how it grows, where they stay: each refers to the one before.
    struct Planned {
        explicit Planned(scene::Scene grown)
            : scene(std::move(grown))
        {
        }

        scene::Scene scene;
        std::unique_ptr<variation::GrowthPlan const> plan {};
        std::unique_ptr<variation::Grower> grower {};
    };
    static Result<std::unique_ptr<Planned>> planned(scene::Scene scene);

    std::unique_ptr<Planned> shared_;
    double construction_ = 0;
    std::unique_ptr<Planned> varied_ {}; // Of the last key; null where it could not be.
    std::optional<variation::PlantKey> key_ {};
    std::size_t failed_count_ = 0;
};

} // namespace tractus::batch
