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

// The inputs of growth that are common to all plants of a collection, in a layout that is efficient
// for Grower. Immutable after plan_growth(), so that any number of threads may use it.
struct GrowthPlan {
    struct Segment {
        // Frame of the segment in the predefined shape, plant frame.
        Quat frame = Quat::Identity();
        double length_mm = 0;
        // Index into `steps`: the step from the previous segment to this one.
        std::uint32_t step = 0;
        // Index into `parent_frame`, which lists the segments with attachments; kNone if nothing is
        // attached to the segment.
        std::uint32_t parent = kNone;
    };

    // Attachment of an axis, organ or polygon to the end of a segment.
    struct Seat {
        // Segment::parent of the parent segment; kNone: on the ground.
        std::uint32_t parent = kNone;
        NodeId node = 0; // Node at the end of the parent segment.
    };

    // Offsets and orientations of attachments are in the frame of the parent segment; for
    // attachments on the ground, in the plant frame.
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
    // One for each segment of `base`, in its order; the following lists also follow `base`.
    std::vector<Segment> segments;
    std::vector<AxisAttachment> axes;
    std::vector<OrganAttachment> organs;
    std::vector<PolygonAttachment> polygons;
    // Vertices of the polygons, relative to the node of their polygon's seat.
    std::vector<Vec3> vertex_offset_mm;
    // Normals of the sections at all nodes (Plant::node_section), each in the frame of the segment
    // that begins at the node, or of the axis' last segment at its tip. Empty if all sections are
    // round; otherwise every segment counts as one with attachments.
    std::vector<Vec3f> section_normal;
    std::vector<GrowthStep> steps;
    // Deviation that circumnutation adds at each segment's step; empty without circumnutation.
    std::vector<Vec2> circumnutation_rad;
    std::vector<double> axis_length_mm;
    // Frame, in the predefined shape, of each segment with attachments, by Segment::parent.
    std::vector<Quat> parent_frame;
};

// Makes the plan of a plant. `rest` and `shape` must belong to `base`. Fails, in one sentence, if a
// parameter is out of range or an influence is not finite. If `stop` is requested, returns an empty
// plan early.
Result<GrowthPlan> plan_growth(Plant base, RestShape const& rest, PredefinedShape const& shape,
                               GrowthParameters const& parameters, Influence influence,
                               std::stop_token const& stop = {});

} // namespace tractus::variation
