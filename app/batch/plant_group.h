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

// All plants of a document that are not hidden, as one plant in the frame of the first of them:
// where each stands, all of one variation and age.
class PlantGroup {
public:
    // Fails like plan_growth(), and, as the user's fault, where all plants are hidden.
    static Result<PlantGroup> create(scene::Scene const& scene);

    // As the station's window shows them: each as drawn, grown as is set, at its age.
    Plant as_set();

    // From here on what would grow into the ground is bent along it (bend_along_ground()).
    void keep_above_ground() { is_above_ground_ = true; }

    // From here on those of a collection are individuals (variation/individual.h), each turned
    // about its own base; branches that were drawn stay.
    void make_individuals(variation::Individuality const& how) { individuality_ = how; }

    // The segments of the last plant given that lie below the ground, roots aside.
    std::size_t underground() const { return underground_; }

    // As of a collection. It is the group's own and holds until the next call. Without what has not
    // grown at that age.
    Plant const& grow(variation::PlantKey const& key, double age);

private:
    struct Member {
        // Stays where it is: the grower has a reference.
        std::unique_ptr<variation::GrowthPlan const> plan;
        variation::Grower grower;
        scene::SetGrowth growth;
        Vec3 moved_mm = Vec3::Zero(); // From its own frame to the first one's.
        std::vector<bool> kept {};    // Axes that were drawn, and what bears them.
    };

    Plant const& grown(Member& member, variation::PlantKey const& key, double age, Plant& bent);
    Plant const& of_collection(std::size_t number, variation::PlantKey key, double age,
                               Plant& plant);

    std::vector<std::unique_ptr<Member>> members_; // At least one.
    Plant whole_;
    bool is_above_ground_ = false;
    std::size_t underground_ = 0;
    variation::Individuality individuality_ {};
};

// PlantGroup::as_set() of a document, as it is. Fails like PlantGroup::create().
Result<Plant> shown_plants(scene::Scene const& scene);

} // namespace tractus::batch
