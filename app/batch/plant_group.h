#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/scene/scene.h"
#include "engine/variation/growth.h"

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
    Plant as_set() const;

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
    };

    std::vector<std::unique_ptr<Member>> members_; // At least one.
    Plant whole_;
};

// PlantGroup::as_set() of a document. Fails like PlantGroup::create().
Result<Plant> shown_plants(scene::Scene const& scene);

} // namespace tractus::batch
