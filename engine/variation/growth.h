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

// Grows plants from one GrowthPlan (Streit 2006, section 4.5), by the law of growth_law.h. Every
// plant has the topology, segment lengths, radii and organs of the base plant; branches bend, and
// their laterals and organs move with them. The same key gives a bit-identical plant on any number
// of threads.
//
// Uses all threads of the calling task arena. Not thread-safe.
class Grower {
public:
    // `plan` must outlive the grower.
    explicit Grower(GrowthPlan const& plan);

    // Returns the plant of `key`. The reference is valid until the next call: all plants use the
    // same memory.
    //
    // With an `age` from 0 to below 1, returns the same plant when it was young: the parts that its
    // apices had reached by then (AxisAge) are present but thinner, and parts that have matured
    // have their final positions. Organs unfold once the segment below them is complete, but every
    // growing shoot carries leaves (YoungLeaves). The topology is that of the whole plant: parts
    // that have not grown yet have no length, radius or size, and lie at the apex below them. So
    // plants of all ages can be blended vertex by vertex. without_unborn() removes the parts that
    // have not grown.
    //
    // Returns early, with an unusable plant, if `stop` is requested.
    Plant const& grow(PlantKey const& key, double age = 1, std::stop_token const& stop = {});

private:
    void age_plant(double age);

    GrowthPlan const& plan_;
    Plant plant_;
    // Frame, after growth, of each segment with attachments, in the order of
    // GrowthPlan::parent_frame.
    std::vector<Quat> parent_frame_;
    SagSimulator sag_simulator_;
    std::optional<YoungLeaves> young_leaves_; // Created when a young plant is first grown.
    bool is_aged_ = false; // True if the radii and sizes of plant_ are those of a younger plant.
};

// Returns a young plant (Grower::grow()) without the segments, axes, organs and polygons that have
// no length or size yet. The other parts keep their order but get new numbers. An organ whose
// segment has not grown is attached to the nearest grown segment below.
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

// Grows one plant from its complete inputs. Fails if resolve_associations(), influence_of() or
// plan_growth() fails.
Result<Plant> grow(GrowthJob const& job);

} // namespace tractus::variation
