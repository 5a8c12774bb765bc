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

// Everything about a plant's growth that is common to all plants of a collection, in a layout that
// is efficient for Grower. Made once and immutable; may be used by any number of threads.
struct GrowthPlan {
    struct Segment {
        // Predefined frame, in the coordinates of the predefined plant.
        Quat frame = Quat::Identity();
        double length_mm = 0;
        // Index into `steps`: the step from the previous segment to this one.
        std::uint32_t step = 0;
        // Number among the segments with attachments (parent_frame), or kNone if nothing is
        // attached.
        std::uint32_t parent = kNone;
    };

    // Attachment of an axis, organ or polygon to the end of a segment.
    struct Seat {
        // Number of the parent segment, as in Segment::parent; kNone: on the ground.
        std::uint32_t parent = kNone;
        NodeId node = 0; // Node at the end of the parent segment.
    };

    // Offsets and orientations are in the frame of the parent segment, or in the plant frame on the
    // ground.
    struct AxisAttachment {
        Seat seat;
        // Offset from the seat's node to the axis' base; usually zero.
        Vec3 offset_mm = Vec3::Zero();
        AxisAge age;
    };

    struct OrganAttachment {
        Seat seat;
        Vec3 offset_mm = Vec3::Zero();
        Quat orientation = Quat::Identity();
        double birth = 0; // Age of the plant at which the organ appears, 0 to kSkeletonShare.
    };

    struct PolygonAttachment {
        Seat seat;
        double birth = 0;
    };

    Plant base; // The base plant; grown plants are copies of it with their nodes moved.
    GrowthParameters parameters;
    Influence influence;

    AxisLevels levels;
    std::vector<Segment> segments; // In the plant's order, like the following lists.
    std::vector<AxisAttachment> axes;
    std::vector<OrganAttachment> organs;
    std::vector<PolygonAttachment> polygons;
    std::vector<Vec3> vertex_offset_mm; // Polygon vertices relative to the seat of their polygon.
    // Normals of nodes with a section that is not round (Plant::node_section), in the frame of the
    // segment that begins there, or of the axis' last. Empty if all sections are round; otherwise
    // every segment counts as one with attachments.
    std::vector<Vec3f> section_normal;
    std::vector<GrowthStep> steps;
    // Circumnutation: deviation added at each segment's step; empty if there is none.
    std::vector<Vec2> circumnutation_rad;
    std::vector<double> axis_length_mm;
    // Predefined frame of each segment with attachments, by Segment::parent.
    std::vector<Quat> parent_frame;
};

// Makes the plan of a plant. `rest` and `shape` must belong to `base`. Fails, in one sentence, if a
// parameter is out of range or an influence is not finite. Returns early, without segments, if
// `stop` is requested.
Result<GrowthPlan> plan_growth(Plant base, RestShape const& rest, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Influence influence,
                               std::stop_token const& stop = {});

} // namespace tractus::variation
