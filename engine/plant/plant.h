#pragma once

#include "engine/plant/contour.h"
#include "engine/plant/material.h"
#include "engine/plant/organ_shape.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tractus {

// Segment number: axis after axis, from base to tip within an axis.
using SegmentId = std::uint32_t;
using AxisId = std::uint32_t;
using NodeId = std::uint32_t;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A sequence of segments (internodes) produced by one apex. Its nodes and segments are contiguous
// in the plant's arrays; segment i of the axis connects its nodes i and i + 1.
struct Axis {
    NodeId first_node = 0;
    SegmentId first_segment = 0;
    std::uint32_t segment_count = 0; // At least 1; the axis has one more node than segments.
    // The segment to whose end the axis is attached; kNone: on the ground.
    SegmentId parent_segment = kNone;
    AxisId parent_axis = kNone; // The axis that contains parent_segment.
    std::uint32_t order = 0; // Branching order: 0 for the trunk, the parent's plus 1 for a lateral.
};

// A leaf, flower or fruit: an instance of one of the plant's organ shapes.
struct Organ {
    OrganShapeId shape = 0;
    // The segment to whose end the organ is attached; kNone: on the ground.
    SegmentId segment = kNone;
    Vec3 position_mm = Vec3::Zero();
    // Rotation from the organ frame (organ_shape.h) to the plant frame.
    Quat orientation = Quat::Identity();
    Vec3f scale = Vec3f::Ones(); // Scale factors along the axes of the organ frame.
};

// A filled polygon drawn by the turtle; flat or nearly so, with at least three vertices.
struct Polygon {
    std::uint32_t first_vertex = 0; // Index into Plant::polygon_vertices_mm.
    std::uint32_t vertex_count = 0;
    SegmentId segment = kNone; // The segment to whose end the polygon is attached.
    MaterialId material = 0;
};

// Root flare of trunks: ridges that run down a trunk into its roots. They make the section at the
// ground lobed and fade within about the trunk's diameter. The mean radius, and thus the widening,
// is that of the nodes.
struct RootFlare {
    int ridges = 0;  // Number of ridges, 0 to 12; 0: the trunk stays round.
    float depth = 0; // Height of the ridges at the ground, as a share of the radius; 0 to 0.5.
    float turn = 0;  // Direction of the ridges about +z, in radians.
};

// The skeleton and organs of a plant: pure data, produced by L-systems, growth models and
// importers.
//
// Plant frame: right-handed, +z up, origin at the plant's base, millimetres at the plant's natural
// size. Invariants, verified by check_plant(): parents come before their children, arrays are
// contiguous and complete, every index is in range, every number is finite.
struct Plant {
    std::vector<Axis> axes;
    std::vector<Vec3> node_position_mm;       // One per node.
    std::vector<float> node_radius_mm;        // One per node; at least 0.
    std::vector<MaterialId> segment_material; // One per segment.
    std::vector<Organ> organs;
    std::vector<Polygon> polygons;
    std::vector<Vec3> polygon_vertices_mm;
    std::vector<Material> materials;
    std::vector<OrganShape> organ_shapes;
    // Outlines of cross-sections that are not round, and the cross-section at each node. Both lists
    // are empty if all cross-sections are round.
    std::vector<Contour> contours;
    std::vector<NodeSection> node_section;
    // Applies to axes that stand on the ground and are among the thickest.
    RootFlare root_flare {};

    std::size_t segment_count() const { return segment_material.size(); }

    // Positions of the nodes of an axis, base first.
    std::span<Vec3 const> positions(Axis const& axis) const
    {
        return std::span(node_position_mm)
            .subspan(axis.first_node, axis.segment_count + std::size_t { 1 });
    }
};

// True if any cross-section of the axis is not round.
bool has_contour(Plant const& plant, Axis const& axis);

// Returns the axis of a segment, in O(log axes).
AxisId axis_of(Plant const& plant, SegmentId segment);

// The two end nodes of a segment. nodes_of() takes O(log axes), so loops over an axis should use
// its node range instead.
struct SegmentNodes {
    NodeId base = 0;
    NodeId tip = 0;
};
SegmentNodes nodes_of(Plant const& plant, SegmentId segment);

// Returns the segment below `segment`: the previous segment of its axis. For the first segment of
// an axis, returns the segment that the axis is attached to, or kNone if it is on the ground.
SegmentId parent_segment(Plant const& plant, SegmentId segment);

// Arc length of an axis.
double axis_length_mm(Plant const& plant, Axis const& axis);

struct Bounds {
    Vec3 min_mm = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max_mm = Vec3::Constant(-std::numeric_limits<double>::infinity());

    bool empty() const { return !(min_mm.x() <= max_mm.x()); }
    void add(Vec3 const& point);
};

// Bounding box of the nodes, the organs' points of attachment and the polygons' vertices. Empty for
// an empty plant.
Bounds bounds(Plant const& plant);

// Aborts with CHECK if `plant` violates an invariant of Plant. For tests of code that makes plants.
void check_plant(Plant const& plant);

} // namespace tractus
