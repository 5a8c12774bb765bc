#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace tractus::batch {

// All visible plants of a document, merged into one plant in the frame of the first of them. The
// plants of the group vary together: they share the growth key and the age.
class PlantGroup {
public:
    // Fails like plan_growth(), and with a user error if all plants are hidden.
    static Result<PlantGroup> create(scene::Scene const& scene);

    // The plants as the window shows them: as drawn, with their own growth and age.
    Plant plant_as_displayed();

    // From now on, plants bend along the ground instead of growing into it (bend_along_ground()).
    void keep_above_ground() { is_above_ground_ = true; }

    // From now on, the plants have individual differences, as in a collection
    // (variation/individual.h). Each plant turns about its own base. Drawn branches are never
    // removed.
    void make_individuals(variation::Individuality const& how) { individuality_ = how; }

    // Number of segments of the last returned plant that are below the ground, except roots.
    std::size_t underground() const { return underground_; }

    // Returns the group's plants, merged, for one key of a collection, without the parts that have
    // not grown at that age. The result is owned by the group and valid until the next call.
    Plant const& grow(variation::PlantKey const& key, double age);

private:
    struct Member {
        // On the heap, as the grower holds a reference to it.
        std::unique_ptr<variation::GrowthPlan const> plan;
        variation::Grower grower;
        scene::SetGrowth growth;
        // Position of the plant's base in the frame of the group's first plant.
        Vec3 moved_mm = Vec3::Zero();
        std::vector<bool> kept {}; // For each axis: true if it was drawn or carries a drawn axis.
    };

    Plant const& grown(Member& member, variation::PlantKey const& key, double age, Plant& bent);
    Plant const& of_collection(std::size_t number, variation::PlantKey key, double age,
                               Plant& plant);

    std::vector<std::unique_ptr<Member>> members_; // The group's plants, at least one.
    Plant whole_;
    bool is_above_ground_ = false;
    std::size_t underground_ = 0;
    variation::Individuality individuality_ {};
};

// Returns PlantGroup::plant_as_displayed() of a document. With `along_ground`, the plants bend
// along the ground. Fails like PlantGroup::create().
Result<Plant> shown_plants(scene::Scene const& scene, bool along_ground = false);

} // namespace tractus::batch
