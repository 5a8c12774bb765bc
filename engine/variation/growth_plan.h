#pragma once

#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/variation/association.h"
#include "engine/variation/axis_age.h"
#include "engine/variation/growth_law.h"
#include "engine/variation/influence.h"
#include "engine/variation/rest_shape.h"

#include <span>
#include <stop_token>
#include <vector>

namespace tractus::variation {

// Everything about a plant's growth that is the same for all plants of a collection, laid out for
// the loop that grows them: make it once, then let Grower use it as often as there are plants.
// Values only, and nothing in it changes; any number of threads may use it.
struct GrowthPlan {
    struct Segment {
        Quat frame = Quat::Identity(); // Predefined, in the predefined plant's coordinates.
        double length_mm = 0;
        std::uint32_t step = 0;       // Into `steps`: from the segment before to this one.
        std::uint32_t parent = kNone; // Number among the segments that bear something, or kNone.
    };

    // Something that stands on the end of a segment: an axis, organ or polygon.
    struct Seat {
        std::uint32_t parent = kNone; // Parent as above; kNone: stands on the ground.
        NodeId node = 0;              // The bearing segment's tip.
    };

    // Offsets and orientations are in the frame of the bearing segment; in the plant's where
    // something stands on the ground.
    struct AxisSeat {
        Seat seat;
        Vec3 offset_mm = Vec3::Zero(); // Offset from the seat's node; usually zero.
        AxisAge age;
    };

    struct OrganSeat {
        Seat seat;
        Vec3 offset_mm = Vec3::Zero();
        Quat orientation = Quat::Identity();
        double birth = 0; // Age of the plant, 0 to kSkeletonShare.
    };

    struct PolygonSeat {
        Seat seat;
        double birth = 0;
    };

    Plant base; // Copied and moved to grow.
    GrowthParameters parameters;
    Influence influence;

    AxisLevels levels;
    std::vector<Segment> segments; // Segments in the plant's order, as the next ones.
    std::vector<AxisSeat> axes;
    std::vector<OrganSeat> organs;
    std::vector<PolygonSeat> polygons;
    std::vector<Vec3> vertex_offset_mm; // Offset of polygon vertices, from their polygon's seat.
    // Normals of nodes whose section is not round (Plant::node_section), in the frame of the
    // segment above, or of the axis' last; empty where there is none. Then every segment is a
    // bearing one.
    std::vector<Vec3f> section_normal;
    std::vector<GrowthStep> steps;
    // Deviation that each segment's step adds; empty where there is none.
    std::vector<Vec2> circumnutation_rad;
    std::vector<double> axis_length_mm;
    // Per bearing segment: its predefined frame.
    std::vector<Quat> parent_frame;
};

// `rest` and `shape` must be of `base`. Refuses, in a sentence, parameters out of range and an
// influence that is not finite. Ends early when `stop` asks for it; the plan is then without
// segments.
Result<GrowthPlan> plan_growth(Plant base, RestShape const& rest, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Influence influence,
                               std::stop_token const& stop = {});

} // namespace tractus::variation
