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

// Numbers every segment of a plant, axis after axis, from base to tip within an axis.
using SegmentId = std::uint32_t;
using AxisId = std::uint32_t;
using NodeId = std::uint32_t;

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A sequence of segments (internodes) that one apex made. Its nodes and segments are contiguous in
// the plant's arrays; segment i of the axis joins its nodes i and i + 1.
struct Axis {
    NodeId first_node = 0;
    SegmentId first_segment = 0;
    std::uint32_t segment_count = 0;  // At least 1; the axis has one more node than segments.
    SegmentId parent_segment = kNone; // Stands on its end; kNone: stands on the ground.
    AxisId parent_axis = kNone;       // The axis of that segment.
    std::uint32_t order = 0; // 0 for the trunk; a lateral axis has its parent's order plus 1.
};

// A leaf, flower, fruit: an instance of one of the plant's organ shapes.
struct Organ {
    OrganShapeId shape = 0;
    SegmentId segment = kNone; // Rides on the end of this segment; kNone: stands on the ground.
    Vec3 position_mm = Vec3::Zero();
    Quat orientation = Quat::Identity(); // Takes the organ's frame (organ_shape.h) to the plant's.
    Vec3f scale = Vec3f::Ones();         // Along the organ's own axes.
};

// A filled polygon that the turtle drew. Flat or nearly so; at least three vertices.
struct Polygon {
    std::uint32_t first_vertex = 0; // Into Plant::polygon_vertices_mm.
    std::uint32_t vertex_count = 0;
    SegmentId segment = kNone; // Rides on the end of this segment.
    MaterialId material = 0;
};

// A plant's skeleton and organs: pure data, as L-systems, growth and other makers give it.
//
// Plant frame: right-handed, +z up, origin at the plant's base, millimetres at the plant's natural
// size. Topology invariants, which check_plant() proves: parents come before their children, arrays
// are contiguous and complete, every index is in range, every number is finite.
struct Plant {
    std::vector<Axis> axes;
    std::vector<Vec3> node_position_mm;       // One per node.
    std::vector<float> node_radius_mm;        // One per node; 0 or more.
    std::vector<MaterialId> segment_material; // One per segment.
    std::vector<Organ> organs;
    std::vector<Polygon> polygons;
    std::vector<Vec3> polygon_vertices_mm;
    std::vector<Material> materials;
    std::vector<OrganShape> organ_shapes;
    // Cross-sections that are not round. Most plants have none: then both are empty. Otherwise
    // there is one section per node.
    std::vector<Contour> contours;
    std::vector<NodeSection> node_section;

    std::size_t segment_count() const { return segment_material.size(); }

    // The nodes of an axis, base first.
    std::span<Vec3 const> positions(Axis const& axis) const
    {
        return std::span(node_position_mm)
            .subspan(axis.first_node, axis.segment_count + std::size_t { 1 });
    }
};

// Whether any cross-section of the axis is not round.
bool has_contour(Plant const& plant, Axis const& axis);

// The axis of a segment. O(log axes).
AxisId axis_of(Plant const& plant, SegmentId segment);

// The two ends of a segment, base end first. O(log axes); loops over an axis use its node range.
struct SegmentNodes {
    NodeId base = 0;
    NodeId tip = 0;
};
SegmentNodes nodes_of(Plant const& plant, SegmentId segment);

// The segment below this one: within its axis, or the one its axis stands on. kNone at the base.
SegmentId parent_segment(Plant const& plant, SegmentId segment);

// Length of an axis along its segments.
double axis_length_mm(Plant const& plant, Axis const& axis);

struct Bounds {
    Vec3 min_mm = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max_mm = Vec3::Constant(-std::numeric_limits<double>::infinity());

    bool empty() const { return !(min_mm.x() <= max_mm.x()); }
    void add(Vec3 const& point);
};

// The box around the nodes and organs' attachments. Empty for an empty plant.
Bounds bounds(Plant const& plant);

// Aborts with CHECK if `plant` breaks an invariant above: whoever makes plants calls it in tests.
void check_plant(Plant const& plant);

} // namespace tractus
