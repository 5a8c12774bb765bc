#pragma once

#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/scene/varied_scene.h"
#include "engine/variation/growth.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace tractus::batch {

// Grows the plants of a collection one after the other, all from one plant or each from a varied
// one (varied_scene.h).
class CollectionGrower {
public:
    // `construction` is SourceVariation::spread. If it is 0, or nothing in the scene can vary in
    // this way, all plants have the drawn plant's segments. Fails like plan_growth().
    static Result<CollectionGrower> create(scene::Scene scene, double construction);

    // Derives models with stochastic rules by a seed of their own for a share of the plants
    // (Individuality::seeds).
    void reseed(double share) { own_seeds_ = { shared_->scene, share }; }

    // Enables bending growth along the ground instead of into it (bend_along_ground()).
    void keep_above_ground() { is_above_ground_ = true; }

    // Enables individual differences (variation/individual.h); drawn branches stay. The individual
    // turn is left out, as plants are turned when placed.
    void make_individuals(variation::Individuality const& how) { individuality_ = how; }

    // Number of segments of the last returned plant that are below the ground, except roots.
    std::size_t underground() const { return underground_; }

    // True if all plants have the same sketched parts, so that their nodes can be compared.
    bool has_one_topology() const { return construction_ == 0; }

    // The plant as drawn; and the plant of a key, valid until the next call.
    Result<Plant> drawn() const;
    Plant const& grow(variation::PlantKey const& key, double age = 1);

    // The plant of a key in a form that can be compared node by node (comparable_individual()).
    Plant comparable(variation::PlantKey const& key, double age);

    // Number of plants whose construction could not be varied; they are as drawn except for their
    // growth.
    std::size_t failed_count() const { return failed_count_; }

private:
    // A scene and its growth. Not movable, as members refer to earlier ones.
    struct Planned {
        explicit Planned(scene::Scene grown)
            : scene(std::move(grown))
        {
        }

        scene::Scene scene;
        std::unique_ptr<variation::GrowthPlan const> plan {};
        std::unique_ptr<variation::Grower> grower {};
        std::vector<bool> kept {}; // True for axes that were drawn and the axes that carry them.
    };
    static Result<std::unique_ptr<Planned>> planned(scene::Scene scene);
    Planned& planned_of(variation::PlantKey const& key);
    Plant const& grown(Planned& planned, variation::PlantKey const& key, double age);

    std::unique_ptr<Planned> shared_;
    bool is_varied(variation::PlantKey const& key) const;
    Result<std::unique_ptr<Planned>> planned_for(variation::PlantKey const& key) const;

    double construction_ = 0;
    scene::SeedAssignment own_seeds_ {};
    std::unique_ptr<Planned> varied_ {}; // Varied plant of the last key; null if variation failed.
    std::optional<variation::PlantKey> key_ {};
    std::size_t failed_count_ = 0;
    bool is_above_ground_ = false;
    std::size_t underground_ = 0;
    variation::Individuality individuality_ {};
    Plant bent_ {};       // The last plant bent along the ground.
    Plant individual_ {}; // The last plant with individual differences.
};

} // namespace tractus::batch
