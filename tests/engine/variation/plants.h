#pragma once

#include "engine/plant/plant.h"
#include "engine/stroke/frames.h"

#include <cmath>
#include <vector>

namespace tractus::variation {

// Adds an axis whose nodes are `points`. It begins at the end of `parent_segment` on `parent_axis`.
inline AxisId add_axis(Plant& plant, std::vector<Vec3> const& points, AxisId parent_axis = kNone,
                       SegmentId parent_segment = kNone)
{
    if (plant.materials.empty())
        plant.materials.push_back({});
    auto const id = static_cast<AxisId>(plant.axes.size());
    auto const segments = static_cast<std::uint32_t>(points.size() - 1);
    plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                           .first_segment = static_cast<SegmentId>(plant.segment_count()),
                           .segment_count = segments,
                           .parent_segment = parent_segment,
                           .parent_axis = parent_axis,
                           .order = parent_axis == kNone ? 0 : plant.axes[parent_axis].order + 1 });
    for (auto const& point : points) {
        plant.node_position_mm.push_back(point);
        plant.node_radius_mm.push_back(2);
    }
    plant.segment_material.resize(plant.segment_count() + segments, 0);
    return id;
}

// Returns the nodes of a straight line from `base` to `tip` that is divided into `segments` equal
// parts.
inline std::vector<Vec3> straight(Vec3 const& base, Vec3 const& tip, int segments)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= segments; ++i)
        points.push_back(base + (tip - base) * (static_cast<double>(i) / segments));
    return points;
}

// Returns a plant that consists of a straight vertical axis.
inline Plant pole(int segments, double height_mm = 1000)
{
    Plant plant;
    add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, height_mm }, segments));
    return plant;
}

// Returns a plant with a vertical trunk of four segments (0 to 3). At the end of its second
// segment, it has a branch of three segments to the right (4 to 6). This branch has, at the end of
// its first segment, a twig of two segments upwards (7, 8). At the end of the trunk's third segment
// is a branch of two segments to the left (9, 10). There is a leaf on the tip of the twig, on the
// tip of the trunk and on the ground, and a polygon on the left branch.
inline Plant hand_made_plant()
{
    Plant plant;
    auto const trunk = add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, 400 }, 4));
    auto const right = add_axis(plant, straight({ 0, 0, 200 }, { 150, 0, 200 }, 3), trunk, 1);
    add_axis(plant, straight({ 50, 0, 200 }, { 50, 0, 260 }, 2), right, 4);
    add_axis(plant, straight({ 0, 0, 300 }, { -100, 0, 300 }, 2), trunk, 2);
    plant.organ_shapes = { OrganShape {} };
    plant.organs = { Organ { .segment = 8, .position_mm = { 50, 0, 260 } },
                     Organ { .segment = 3, .position_mm = { 0, 5, 400 } },
                     Organ { .segment = kNone, .position_mm = { 80, 80, 0 } } };
    plant.polygon_vertices_mm = { { -100, 0, 300 }, { -110, 0, 300 }, { -100, 10, 300 } };
    plant.polygons = { Polygon { .first_vertex = 0, .vertex_count = 3, .segment = 10 } };
    return plant;
}

// Returns a tree that forks `depth` times: it has 2^depth - 1 axes of `segments` segments each.
// Each of the last axes has a leaf at its end.
inline Plant forking_tree(int depth, int segments)
{
    Plant plant;
    plant.organ_shapes = { OrganShape {} };
    add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, 1000 }, segments));
    std::vector<Frame> frames { Frame {} };
    std::size_t const inner = (std::size_t { 1 } << (depth - 1)) - 1;
    for (std::size_t parent = 0; parent < inner; ++parent) {
        auto const axis = plant.axes[parent];
        Vec3 const fork = plant.positions(axis).back();
        double const length_mm = 0.75 * (fork - plant.positions(axis).front()).norm();
        for (double const side : { -1.0, 1.0 }) {
            Quat const turn(Eigen::AngleAxisd(side * radians(28), frames[parent].normal));
            Vec3 const direction = (turn * frames[parent].tangent).normalized();
            frames.push_back({ direction, direction.cross(frames[parent].normal).normalized() });
            add_axis(plant, straight(fork, fork + length_mm * direction, segments),
                     static_cast<AxisId>(parent), axis.first_segment + axis.segment_count - 1);
        }
    }
    for (std::size_t id = inner; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        plant.organs.push_back({ .segment = axis.first_segment + axis.segment_count - 1,
                                 .position_mm = plant.positions(axis).back() });
    }
    return plant;
}

// Returns a tree of `axes` axes with `segments` segments each. Each axis has five laterals, one on
// each of its last five segments.
inline Plant wide_tree(std::size_t axes, int segments)
{
    Plant plant;
    add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, 1000 }, segments));
    for (std::size_t id = 1; id < axes; ++id) {
        auto const parent = static_cast<AxisId>((id - 1) / 5);
        auto const seat = static_cast<std::uint32_t>(segments - 1) - (id - 1) % 5;
        auto const& axis = plant.axes[parent];
        Vec3 const base = plant.positions(axis)[seat + 1];
        Vec3 const along = plant.positions(axis)[1] - plant.positions(axis)[0];
        Quat const turn(Eigen::AngleAxisd(2.4 * static_cast<double>(id), Vec3::UnitZ()));
        Vec3 const direction = (along.normalized() + turn * Vec3::UnitX()).normalized();
        Vec3 const tip = base + 0.55 * segments * along.norm() * direction;
        add_axis(plant, straight(base, tip, segments), parent,
                 axis.first_segment + static_cast<SegmentId>(seat));
    }
    return plant;
}

// Returns the direction of a segment.
inline Vec3 direction_of(Plant const& plant, SegmentId segment)
{
    auto const nodes = nodes_of(plant, segment);
    return (plant.node_position_mm[nodes.tip] - plant.node_position_mm[nodes.base]).normalized();
}

} // namespace tractus::variation
