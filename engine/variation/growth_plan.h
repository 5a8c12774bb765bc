#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/association.h"
#include "engine/variation/axis_levels.h"
#include "engine/variation/growth_law.h"

#include <span>
#include <vector>

namespace tractus {

// Everything about a plant's growth that is the same for all plants of a collection, laid out for
// the loop that grows them: make it once, then let Grower use it as often as there are plants.
// Values only, and nothing in it changes; any number of threads may use it.
struct GrowthPlan {
    struct Segment {
        Vec3 direction = Vec3::UnitZ(); // Predefined, in the predefined plant's coordinates.
        Vec3 normal = Vec3::UnitX();
        double length_mm = 0;
        std::uint32_t step = 0;       // Into `steps`: from the segment before to this one.
        std::uint32_t bearer = kNone; // Number among the segments that bear something, or kNone.
    };

    // Something that stands on the end of a segment: an axis, organ or polygon.
    struct Seat {
        std::uint32_t bearer = kNone; // As above; kNone: stands on the ground.
        NodeId node = 0;              // The bearing segment's tip.
    };

    struct AxisSeat {
        Seat seat;
        // From the seat's node, in the predefined plant; usually zero.
        Vec3 offset_mm = Vec3::Zero();
    };

    struct OrganSeat {
        Seat seat;
        Vec3 offset_mm = Vec3::Zero();
        Quat orientation = Quat::Identity();
    };

    Plant base; // What is grown is a copy of it, moved.
    GrowthParameters parameters;
    Vec3 influence = Vec3::Zero(); // All indicators, in units of the plant's height.

    AxisLevels levels;
    std::vector<Segment> segments; // In the plant's order, as the next ones.
    std::vector<AxisSeat> axes;
    std::vector<OrganSeat> organs;
    std::vector<Seat> polygons;
    std::vector<Vec3> vertex_offset_mm; // Of polygon vertices, from their polygon's seat.
    std::vector<GrowthStep> steps;
    // What each segment's step adds; empty where there is none.
    std::vector<Vec2> circumnutation_rad;
    std::vector<double> axis_length_mm;
    std::uint32_t bearer_count = 0;
};

// `shape` must be of `base`. `influence` is what summed_influence gives. Refuses, in a sentence,
// parameters out of range and an influence that is not finite.
Result<GrowthPlan> plan_growth(Plant base, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Vec3 const& influence);

} // namespace tractus
