#include "engine/variation/growth.h"

namespace tractus::variation {

namespace {

// Returns the number of an axis' segments that have grown, from its base.
std::uint32_t grown_segments(Plant const& plant, Axis const& axis)
{
    auto const nodes = plant.positions(axis);
    std::uint32_t count = axis.segment_count;
    while (count > 0 && nodes[count] == nodes[count - 1])
        --count;
    return count;
}

// Returns the new number of a segment; kNone for a segment that has not grown, and for the ground.
SegmentId renumbered(std::vector<SegmentId> const& new_segment, SegmentId segment)
{
    return segment == kNone ? kNone : new_segment[segment];
}

void keep_axes(Plant const& plant, Plant& kept, std::vector<SegmentId>& new_segment)
{
    std::vector<AxisId> new_axis(plant.axes.size(), kNone);
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        auto const count = grown_segments(plant, axis);
        bool const is_borne
            = axis.parent_axis == kNone || renumbered(new_segment, axis.parent_segment) != kNone;
        if (count == 0 || !is_borne)
            continue;
        new_axis[id] = static_cast<AxisId>(kept.axes.size());
        Axis now = axis;
        now.first_node = static_cast<NodeId>(kept.node_position_mm.size());
        now.first_segment = static_cast<SegmentId>(kept.segment_count());
        now.segment_count = count;
        now.parent_segment = renumbered(new_segment, axis.parent_segment);
        now.parent_axis = axis.parent_axis == kNone ? kNone : new_axis[axis.parent_axis];
        kept.axes.push_back(now);
        for (std::uint32_t i = 0; i <= count; ++i) {
            kept.node_position_mm.push_back(plant.node_position_mm[axis.first_node + i]);
            kept.node_radius_mm.push_back(plant.node_radius_mm[axis.first_node + i]);
            if (!plant.node_section.empty())
                kept.node_section.push_back(plant.node_section[axis.first_node + i]);
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            new_segment[axis.first_segment + i] = now.first_segment + i;
            kept.segment_material.push_back(plant.segment_material[axis.first_segment + i]);
        }
    }
}

} // namespace

Plant without_unborn(Plant const& plant)
{
    Plant kept;
    kept.materials = plant.materials;
    kept.organ_shapes = plant.organ_shapes;
    kept.contours = plant.contours;
    std::vector<SegmentId> new_segment(plant.segment_count(), kNone);
    keep_axes(plant, kept, new_segment);
    for (auto organ : plant.organs) {
        bool const was_on_ground = organ.segment == kNone;
        while (organ.segment != kNone && new_segment[organ.segment] == kNone)
            organ.segment = parent_segment(plant, organ.segment);
        organ.segment = renumbered(new_segment, organ.segment);
        if ((was_on_ground || organ.segment != kNone) && !organ.scale.isZero(0))
            kept.organs.push_back(organ);
    }
    for (auto polygon : plant.polygons) {
        auto const* const vertices = &plant.polygon_vertices_mm[polygon.first_vertex];
        bool const is_there = polygon.segment == kNone || new_segment[polygon.segment] != kNone;
        if (!is_there || vertices[0] == vertices[1])
            continue;
        polygon.segment = renumbered(new_segment, polygon.segment);
        polygon.first_vertex = static_cast<std::uint32_t>(kept.polygon_vertices_mm.size());
        kept.polygon_vertices_mm.insert(kept.polygon_vertices_mm.end(), vertices,
                                        vertices + polygon.vertex_count);
        kept.polygons.push_back(polygon);
    }
    return kept;
}

} // namespace tractus::variation
