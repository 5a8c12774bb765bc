#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/association.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"
#include "engine/variation/growth_sag.h"
#include "engine/variation/influence.h"
#include "engine/variation/young_leaves.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace tractus::variation {

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
    //
    // An `age` below 1 (0 to 1) gives the same plant when it was young: what its apices had reached
    // by then (AxisAge) stands, thinner, and where it has matured all the way as it will stand;
    // organs unfold when the segment below them is complete, but leaves are on every shoot that
    // grows (YoungLeaves). The topology is that of the whole plant: what has not grown yet has no
    // length, radius or size, and lies where its apex is. So plants of all ages can be blended,
    // vertex by vertex; without_unborn gives one alone.
    //
    // Ends early when `stop` asks for it; the plant is good for nothing then.
    Plant const& grow(PlantKey const& key, double age = 1, std::stop_token const& stop = {});

private:
    void age_plant(double age);

    GrowthPlan const& plan_;
    Plant plant_;
    std::vector<Quat> parent_frame_; // Per bearing segment, as it has grown.
    Sagger sagger_;
    std::optional<YoungLeaves> young_leaves_; // Once a young plant has been grown.
    bool is_aged_ = false;                    // Radii and sizes of plant_ are not the base plant's.
};

// The plant without what has no length or size yet: segments, whole axes, organs and polygons.
// Orders stay, numbers are new. A leaf whose segment has not grown belongs to what will bear that.
Plant without_unborn(Plant const& plant);

// Everything that a varied plant is made of.
struct GrowthJob {
    Plant plant {};
    std::vector<Association> associations {};
    std::vector<MotionIndicator> indicators {};
    double shown_height_mm = 0; // As in ShownPlant; above 0 where there are indicators.
    double scale = 1;           // As in ShownPlant.
    GrowthParameters parameters {};
    PlantKey key {};
    double age = 1; // 0 to 1: see Grower::grow().
};

// One plant, from the beginning to the end. Refuses what resolve_associations, influence_of and
// plan_growth refuse.
Result<Plant> grow(GrowthJob const& job);

} // namespace tractus::variation
