#include "engine/variation/ground.h"

#include "engine/base/check.h"
#include "engine/stroke/frame_rotation.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tractus::variation {

std::vector<SegmentId> segments_underground(Plant const& plant, Plant const& base)
{
    CHECK(plant.node_position_mm.size() == base.node_position_mm.size());
    std::vector<SegmentId> below;
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const tip = axis.first_node + i + 1;
            if (plant.node_position_mm[tip].z() < -kUnderground_mm
                && base.node_position_mm[tip].z() >= -kUnderground_mm)
                below.push_back(axis.first_segment + i);
        }
    return below;
}

std::string describe_underground(std::size_t count, Plant const& plant)
{
    if (count == 0)
        return {};
    return fmt::format("{} of {} segments {} below the ground", count, plant.segment_count(),
                       count == 1 ? "is" : "are");
}

namespace {

// Returns, for each axis, whether a node of it or of an ancestor is below the ground in the base
// plant.
std::vector<bool> find_roots(Plant const& base)
{
    std::vector<bool> is_root(base.axes.size());
    for (AxisId id = 0; id < base.axes.size(); ++id) {
        auto const& axis = base.axes[id];
        auto const nodes = base.positions(axis);
        is_root[id] = (axis.parent_axis != kNone && is_root[axis.parent_axis])
            || std::any_of(nodes.begin(), nodes.end(),
                           [](Vec3 const& node) { return node.z() < -kUnderground_mm; });
    }
    return is_root;
}

NodeId tip_of(Plant const& plant, SegmentId segment, AxisId axis)
{
    auto const& owner = plant.axes[axis];
    return owner.first_node + (segment - owner.first_segment) + 1;
}

// A plant before and after bending. Axes must be bent in the plant's order, parents first.
struct Bending {
    Plant& plant;
    std::vector<Vec3> const before_mm = plant.node_position_mm;
    std::vector<Quat> turn = std::vector<Quat>(plant.segment_count(), Quat::Identity());

    void bend_axis(Axis const& axis, bool is_root);
    // Returns the new position of a point that is attached to the end of a bent segment.
    Vec3 moved(Vec3 const& place_mm, SegmentId segment, AxisId axis) const
    {
        auto const tip = tip_of(plant, segment, axis);
        return plant.node_position_mm[tip] + turn[segment] * (place_mm - before_mm[tip]);
    }
    void carry_riders();
};

void Bending::bend_axis(Axis const& axis, bool is_root)
{
    auto& position = plant.node_position_mm;
    Quat copied_by = Quat::Identity();
    if (axis.parent_segment != kNone) {
        copied_by = turn[axis.parent_segment];
        position[axis.first_node]
            = moved(before_mm[axis.first_node], axis.parent_segment, axis.parent_axis);
    }
    Vec2 heading = Vec2::UnitX(); // Heading of the last segment of the axis that was not vertical.
    for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
        auto const node = axis.first_node + i;
        Vec3 step = copied_by * (before_mm[node + 1] - before_mm[node]);
        double const length_mm = step.norm();
        if (double const level = step.head<2>().norm(); level > 1e-9 * length_mm)
            heading = step.head<2>() / level;
        turn[axis.first_segment + i] = copied_by;
        // Minimum height of the tip's centre. There its underside is on the ground, or, if the
        // segment's base is lower than that, the tip is level with the base, but not below the
        // ground.
        double const lowest_mm
            = std::min<double>(plant.node_radius_mm[node + 1], std::max(position[node].z(), 0.0));
        double const rise_mm = lowest_mm - position[node].z();
        if (!is_root && length_mm > 0 && step.z() < rise_mm) {
            double const sine = std::clamp(rise_mm / length_mm, -1.0, 1.0);
            Vec3 bent;
            bent << std::sqrt(1 - sine * sine) * heading, sine;
            turn[axis.first_segment + i]
                = renormalised(least_rotation(step / length_mm, bent) * copied_by);
            step = length_mm * bent;
        }
        position[node + 1] = position[node] + step;
    }
}

void Bending::carry_riders()
{
    for (auto& organ : plant.organs)
        if (organ.segment != kNone) {
            organ.position_mm
                = moved(organ.position_mm, organ.segment, axis_of(plant, organ.segment));
            organ.orientation = renormalised(turn[organ.segment] * organ.orientation);
        }
    for (auto const& polygon : plant.polygons)
        for (std::uint32_t i = 0; i < polygon.vertex_count && polygon.segment != kNone; ++i) {
            auto& vertex_mm = plant.polygon_vertices_mm[polygon.first_vertex + i];
            vertex_mm = moved(vertex_mm, polygon.segment, axis_of(plant, polygon.segment));
        }
    if (plant.node_section.empty())
        return;
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
            auto& normal = plant.node_section[axis.first_node + i].normal;
            auto const segment = axis.first_segment + std::min(i, axis.segment_count - 1);
            normal = turn[segment].cast<float>() * normal;
        }
}

} // namespace

void bend_along_ground(Plant& plant, Plant const& base)
{
    CHECK(plant.node_position_mm.size() == base.node_position_mm.size());
    auto const is_root = find_roots(base);
    Bending bending { plant };
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        bending.bend_axis(plant.axes[id], is_root[id]);
    bending.carry_riders();
}

} // namespace tractus::variation
