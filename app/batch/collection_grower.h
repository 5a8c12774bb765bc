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

// Grows the plants of a collection one after another: all from the same source plant, or each from
// its own variation of the source plant (varied_scene.h).
class CollectionGrower {
public:
    // `construction` is SourceVariation::spread. If it is 0, or if nothing in the scene has a
    // construction that can vary, all plants have the drawn plant's segments. Fails like
    // plan_growth().
    static Result<CollectionGrower> create(scene::Scene scene, double construction);

    // Gives a share of the plants (Individuality::seeds) their own seed for deriving models with
    // stochastic rules. The other plants share the scene's seed.
    void reseed(double share) { own_seeds_ = { shared_->scene, share }; }

    // From now on, plants bend along the ground instead of growing into it (bend_along_ground()).
    void keep_above_ground() { is_above_ground_ = true; }

    // From now on, plants have individual differences (variation/individual.h). Drawn branches are
    // never removed. Individuals are not turned here, as plants are turned when placed.
    void make_individuals(variation::Individuality const& how) { individuality_ = how; }

    // Number of segments of the last returned plant that are below the ground, except roots.
    std::size_t underground() const { return underground_; }

    // True if all plants have the same sketched parts, so that their nodes can be compared.
    bool has_one_topology() const { return construction_ == 0; }

    // drawn() returns the plant as drawn. grow() returns the plant of a key, valid until the next
    // call.
    Result<Plant> drawn() const;
    Plant const& grow(variation::PlantKey const& key, double age = 1);

    // The plant of a key in a form that can be compared node by node (comparable_individual()).
    Plant comparable(variation::PlantKey const& key, double age);

    // Number of plants whose construction could not be varied. These differ from the drawn plant
    // only in their growth.
    std::size_t failed_count() const { return failed_count_; }

private:
    // A scene and its growth plan. Not movable, as later members refer to earlier ones.
    struct Planned {
        explicit Planned(scene::Scene grown)
            : scene(std::move(grown))
        {
        }

        scene::Scene scene;
        std::unique_ptr<variation::GrowthPlan const> plan {};
        std::unique_ptr<variation::Grower> grower {};
        std::vector<bool> kept {}; // For each axis: true if it was drawn or carries a drawn axis.
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
