#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace tractus::batch {

// Grows the plants of a collection, one after the other: all from one plant, or each from another
// one of its kind (varied_scene.h).
class CollectionGrower {
public:
    // `construction` is SourceVariation::spread; at 0, and where nothing in the scene can vary so,
    // all plants have the drawn one's segments. Fails like plan_growth().
    static Result<CollectionGrower> create(scene::Scene scene, double construction);

    // From here on what would grow into the ground is bent along it (bend_along_ground()).
    void keep_above_ground() { is_above_ground_ = true; }

    // From here on each plant is an individual (variation/individual.h): branches that were drawn
    // stay. Its turn is not made, since plants are turned where they stand.
    void make_individuals(variation::Individuality const& how) { individuality_ = how; }

    // The segments of the last plant given that lie below the ground, roots aside.
    std::size_t underground() const { return underground_; }

    // Whether all plants have the same segments, before they are individuals.
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
        std::vector<bool> kept {}; // Axes that were drawn, and what bears them.
    };
    static Result<std::unique_ptr<Planned>> planned(scene::Scene scene);
    Plant const& grown(Planned& planned, variation::PlantKey const& key, double age);

    std::unique_ptr<Planned> shared_;
    double construction_ = 0;
    std::unique_ptr<Planned> varied_ {}; // Of the last key; null where it could not be.
    std::optional<variation::PlantKey> key_ {};
    std::size_t failed_count_ = 0;
    bool is_above_ground_ = false;
    std::size_t underground_ = 0;
    variation::Individuality individuality_ {};
    Plant bent_ {};       // The last one, if it is to be above the ground,
    Plant individual_ {}; // and if it is an individual.
};

} // namespace tractus::batch
