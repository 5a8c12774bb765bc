#include "engine/plant/join_axes.h"

#include <algorithm>
#include <numeric>

namespace tractus {

namespace {

// For each axis: `next` is the axis that continues it, or kNone; `continues` is true if it
// continues another axis.
struct Continuations {
    std::vector<AxisId> next;
    std::vector<bool> continues;
};

NodeId last_node(Axis const& axis)
{
    return axis.first_node + axis.segment_count;
}

// Cosine of the bend between the end of `axis` and the beginning of `next`.
double straightness(Plant const& plant, Axis const& axis, Axis const& next)
{
    auto const& nodes = plant.node_position_mm;
    Vec3 const before = nodes[last_node(axis)] - nodes[last_node(axis) - 1];
    Vec3 const after = nodes[next.first_node + 1] - nodes[next.first_node];
    double const lengths = before.norm() * after.norm();
    return lengths > 0 ? before.dot(after) / lengths : -1;
}

// True if `a` is a better continuation of `axis` than `b`.
bool is_preferred(Plant const& plant, Axis const& axis, Axis const& a, Axis const& b)
{
    float const radius_a = plant.node_radius_mm[a.first_node];
    float const radius_b = plant.node_radius_mm[b.first_node];
    return radius_a != radius_b ? radius_a > radius_b
                                : straightness(plant, axis, a) > straightness(plant, axis, b);
}

// True if both nodes have round sections, or neither: otherwise one tube ends and another begins.
bool same_outline(Plant const& plant, NodeId a, NodeId b)
{
    return plant.node_section.empty()
        || plant.node_section[a].is_round() == plant.node_section[b].is_round();
}

Continuations find_continuations(Plant const& plant)
{
    Continuations result { std::vector<AxisId>(plant.axes.size(), kNone),
                           std::vector<bool>(plant.axes.size(), false) };
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        if (axis.parent_axis == kNone)
            continue;
        auto const& parent = plant.axes[axis.parent_axis];
        bool const at_end = axis.parent_segment == parent.first_segment + parent.segment_count - 1
            && plant.node_position_mm[axis.first_node] == plant.node_position_mm[last_node(parent)];
        if (!at_end || !same_outline(plant, axis.first_node, last_node(parent)))
            continue;
        auto& next = result.next[axis.parent_axis];
        if (next == kNone || is_preferred(plant, parent, axis, plant.axes[next]))
            next = id;
    }
    for (auto const next : result.next)
        if (next != kNone)
            result.continues[next] = true;
    return result;
}

// True if the axes have the numbers and branching orders that they would get in a newly built
// plant.
bool is_in_order(Plant const& plant)
{
    NodeId next_node = 0;
    SegmentId next_segment = 0;
    for (auto const& axis : plant.axes) {
        bool const is_next = axis.first_node == next_node && axis.first_segment == next_segment;
        auto const order
            = axis.parent_axis == kNone ? axis.order : plant.axes[axis.parent_axis].order + 1;
        if (!is_next || axis.order != order || (axis.parent_axis == kNone && order != 0))
            return false;
        next_node = last_node(axis) + 1;
        next_segment += axis.segment_count;
    }
    return next_node == plant.node_position_mm.size() && next_segment == plant.segment_count();
}

// Appends the segments of `part` to the last axis of `to`. The node where the two meet is shared,
// and gets the smaller of its two radii.
void append(Plant& to, Plant const& from, Axis const& part, std::vector<SegmentId>& new_segment)
{
    auto& axis = to.axes.back();
    NodeId first = part.first_node;
    if (axis.segment_count > 0) {
        to.node_radius_mm.back() = std::min(to.node_radius_mm.back(), from.node_radius_mm[first]);
        ++first;
    }
    auto const end = last_node(part) + 1;
    if (!from.node_section.empty())
        to.node_section.insert(to.node_section.end(), from.node_section.begin() + first,
                               from.node_section.begin() + end);
    to.node_position_mm.insert(to.node_position_mm.end(), from.node_position_mm.begin() + first,
                               from.node_position_mm.begin() + end);
    to.node_radius_mm.insert(to.node_radius_mm.end(), from.node_radius_mm.begin() + first,
                             from.node_radius_mm.begin() + end);
    for (std::uint32_t i = 0; i < part.segment_count; ++i) {
        new_segment[part.first_segment + i] = static_cast<SegmentId>(to.segment_count());
        to.segment_material.push_back(from.segment_material[part.first_segment + i]);
    }
    axis.segment_count += part.segment_count;
}

} // namespace

Plant join_axes(Plant plant)
{
    auto const continuations = find_continuations(plant);
    auto const& continues = continuations.continues;
    if (is_in_order(plant)
        && std::find(continues.begin(), continues.end(), true) == continues.end())
        return plant;
    Plant joined;
    joined.axes.reserve(plant.axes.size());
    joined.node_position_mm.reserve(plant.node_position_mm.size());
    joined.node_radius_mm.reserve(plant.node_radius_mm.size());
    joined.segment_material.reserve(plant.segment_count());

    std::vector<SegmentId> new_segment(plant.segment_count(), kNone);
    std::vector<AxisId> new_axis(plant.axes.size(), kNone);
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        if (continuations.continues[id])
            continue; // This axis has been appended to the axis that it continues.
        auto const& old = plant.axes[id];
        Axis axis { .first_node = static_cast<NodeId>(joined.node_position_mm.size()),
                    .first_segment = static_cast<SegmentId>(joined.segment_count()) };
        if (old.parent_axis != kNone) { // Parents come first, so their new numbers are known.
            axis.parent_segment = new_segment[old.parent_segment];
            axis.parent_axis = new_axis[old.parent_axis];
            axis.order = joined.axes[axis.parent_axis].order + 1;
        }
        joined.axes.push_back(axis);
        for (AxisId part = id; part != kNone; part = continuations.next[part]) {
            new_axis[part] = static_cast<AxisId>(joined.axes.size() - 1);
            append(joined, plant, plant.axes[part], new_segment);
        }
    }

    auto const renumber = [&](SegmentId& segment) {
        if (segment != kNone)
            segment = new_segment[segment];
    };
    joined.organs = plant.organs;
    for (auto& organ : joined.organs)
        renumber(organ.segment);
    joined.polygons = plant.polygons;
    for (auto& polygon : joined.polygons)
        renumber(polygon.segment);
    joined.polygon_vertices_mm = plant.polygon_vertices_mm;
    joined.materials = plant.materials;
    joined.organ_shapes = plant.organ_shapes;
    joined.contours = plant.contours;
    joined.root_flare = plant.root_flare;
    return joined;
}

std::vector<AxisId> axes_in_drawing_order(Plant const& plant)
{
    std::vector<double> length_mm;
    length_mm.reserve(plant.axes.size());
    for (auto const& axis : plant.axes)
        length_mm.push_back(axis_length_mm(plant, axis));
    return axes_in_drawing_order(plant, length_mm);
}

std::vector<AxisId> axes_in_drawing_order(Plant const& plant,
                                          std::span<double const> axis_length_mm)
{
    std::vector<AxisId> order(plant.axes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](AxisId a, AxisId b) {
        auto const order_a = plant.axes[a].order;
        auto const order_b = plant.axes[b].order;
        return order_a != order_b ? order_a < order_b : axis_length_mm[a] > axis_length_mm[b];
    });
    return order;
}

std::vector<SegmentId> segments_of(Axis const& axis)
{
    std::vector<SegmentId> segments(axis.segment_count);
    std::iota(segments.begin(), segments.end(), axis.first_segment);
    return segments;
}

} // namespace tractus
