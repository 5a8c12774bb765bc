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

// Grows plants from one plan (Streit 2006, section 4.5; the law is in growth_law.h). Every plant
// has the topology, segment lengths, radii and organs of the base plant; branches bend, and their
// laterals and organs move with them. The same key gives the same bytes on any number of threads.
//
// Uses all threads of the calling task arena. Not thread-safe.
class Grower {
public:
    // `plan` must outlive the grower.
    explicit Grower(GrowthPlan const& plan);

    // Returns the plant of `key`. The reference is valid until the next call, so growing many
    // plants needs the memory of one.
    //
    // An `age` below 1 (0 to 1) gives the same plant when it was young: the parts that its apices
    // had reached by then (AxisAge) are present but thinner, and parts that have matured already
    // have their final positions. Organs unfold once the segment below them is complete, but every
    // growing shoot carries leaves (YoungLeaves). The topology is that of the whole plant: parts
    // that have not grown yet have no length, radius or size, and lie at their apex. So plants of
    // all ages can be blended vertex by vertex; without_unborn() returns a plant without such
    // parts.
    //
    // Returns early, with an unusable plant, if `stop` is requested.
    Plant const& grow(PlantKey const& key, double age = 1, std::stop_token const& stop = {});

private:
    void age_plant(double age);

    GrowthPlan const& plan_;
    Plant plant_;
    // Frame of each parent segment after growth, in the order of GrowthPlan::parent_frame.
    std::vector<Quat> parent_frame_;
    SagSimulator sag_simulator_;
    std::optional<YoungLeaves> young_leaves_; // Created when a young plant is first grown.
    bool is_aged_ = false; // True if the radii and sizes of plant_ are those of a younger plant.
};

// Returns the plant without segments, axes, organs and polygons that have no length or size yet.
// The others keep their order but get new numbers. A leaf whose segment has not grown is attached
// to the nearest segment below that has.
Plant without_unborn(Plant const& plant);

// All inputs for growing one plant.
struct GrowthJob {
    Plant plant {};
    std::vector<Association> associations {};
    std::vector<MotionIndicator> indicators {};
    double shown_height_mm = 0; // Displayed height of the plant; above 0 if there are indicators.
    double scale = 1;           // World millimetres per plant millimetre, as in ShownPlant.
    GrowthParameters parameters {};
    PlantKey key {};
    double age = 1; // Age of the plant, 0 to 1: see Grower::grow().
};

// Grows one plant from its complete inputs. Fails like resolve_associations(), influence_of() and
// plan_growth().
Result<Plant> grow(GrowthJob const& job);

} // namespace tractus::variation
