#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/association.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/motion_indicator.h"

#include <vector>

namespace tractus {

// Grows plants from one plan (Streit 2006 section 4.5; the law is in growth_law.h). Every plant has
// the base plant's topology, segment lengths, radii and organs; branches bend, and what stands on
// them rides along. The same key gives the same bytes on any number of threads.
//
// Works on all threads of the task arena that it is called in; one grower serves one caller at a
// time.
class Grower {
public:
    // `plan` must outlive the grower.
    explicit Grower(GrowthPlan const& plan);

    // The plant of `key`. It is the grower's own and holds until the next call: growing many plants
    // needs the memory of one.
    Plant const& grow(PlantKey const& key);

private:
    GrowthPlan const& plan_;
    Plant plant_;
    std::vector<Quat> turns_; // Per bearing segment: from the predefined plant to this one.
};

// All that a varied plant is made of.
struct GrowthJob {
    Plant plant {};
    std::vector<Association> associations {};
    std::vector<MotionIndicator> indicators {};
    double shown_height_mm = 0; // See summed_influence; above 0 where there are indicators.
    GrowthParameters parameters {};
    PlantKey key {};
};

// One plant, from the beginning to the end. Refuses what resolve_associations and plan_growth
// refuse.
Result<Plant> grow(GrowthJob const& job);

} // namespace tractus
