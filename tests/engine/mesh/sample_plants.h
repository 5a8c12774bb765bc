#pragma once

#include "engine/base/random.h"
#include "engine/plant/plant.h"

#include <cmath>

namespace tractus::mesh {

// Description of an axis with equal segments. It starts at `base_mm`, bends by a random angle at
// each node, and tapers from `radius_mm` to `tip_radius_mm`.
struct AxisSketch {
    Vec3 base_mm = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();
    double segment_mm = 50;
    std::uint32_t segment_count = 4;
    double radius_mm = 10;
    double tip_radius_mm = 2;
    double bend_rad = 0;
    SegmentId parent_segment = kNone;
    AxisId parent_axis = kNone;
    std::uint32_t order = 0;
};

// Appends the described axis to the plant and returns the axis's id.
inline AxisId append_axis(Plant& plant, AxisSketch const& sketch, Random& random)
{
    plant.axes.push_back({ static_cast<NodeId>(plant.node_position_mm.size()),
                           static_cast<SegmentId>(plant.segment_count()), sketch.segment_count,
                           sketch.parent_segment, sketch.parent_axis, sketch.order });
    Vec3 position = sketch.base_mm;
    Vec3 direction = sketch.direction.normalized();
    for (std::uint32_t i = 0; i <= sketch.segment_count; ++i) {
        double const share = static_cast<double>(i) / sketch.segment_count;
        plant.node_position_mm.push_back(position);
        plant.node_radius_mm.push_back(static_cast<float>(
            sketch.radius_mm + share * (sketch.tip_radius_mm - sketch.radius_mm)));
        if (i > 0)
            plant.segment_material.push_back(0);
        Vec3 const noise(random.normal(), random.normal(), random.normal());
        direction = (direction + sketch.bend_rad * noise).normalized();
        position += sketch.segment_mm * direction;
    }
    return static_cast<AxisId>(plant.axes.size() - 1);
}

inline void add_sample_materials(Plant& plant)
{
    plant.materials = {
        Material {},
        Material { .name = "leaf",
                   .kind = Material::Kind::Leaf,
                   .base_color { 0.33f, 0.5f, 0.16f },
                   .roughness = 0.6f,
                   .translucency = 0.4f },
    };
    plant.organ_shapes
        = { OrganShape { .material = 1, .length_mm = 130, .width_mm = 70, .petiole_mm = 25 } };
}

// Adds branches at all nodes of an axis except its first, and a fork at its end.
inline void add_sample_branches(Plant& plant, AxisId id, Random& random)
{
    auto const parent = plant.axes[id];
    for (std::uint32_t i = 1; i < parent.segment_count; ++i) {
        NodeId const node = parent.first_node + i + 1;
        bool const end = i + 1 == parent.segment_count;
        Vec3 const along
            = (plant.node_position_mm[node] - plant.node_position_mm[node - 1]).normalized();
        double const turn = 2.4 * (i + 3 * id);
        Vec3 const side = (std::cos(turn) * along.unitOrthogonal()
                           + std::sin(turn) * along.cross(along.unitOrthogonal()));
        double const radius = plant.node_radius_mm[node];
        for (int twin = 0; twin < (end ? 2 : 1); ++twin) {
            double const spread = end ? (twin == 0 ? 0.45 : -0.45) : 0.9;
            double const own = radius * (end ? 0.75 : 0.4);
            append_axis(plant,
                        { .base_mm = plant.node_position_mm[node],
                          .direction = std::cos(spread) * along + std::sin(spread) * side,
                          .segment_mm = 230.0 / (1 + parent.order),
                          .segment_count = 6 - parent.order,
                          .radius_mm = own,
                          .tip_radius_mm = own * 0.5,
                          .bend_rad = 0.15,
                          .parent_segment = parent.first_segment + i,
                          .parent_axis = id,
                          .order = parent.order + 1 },
                        random);
        }
    }
}

// Adds a leaf at each node of an axis except its first.
inline void add_sample_leaves(Plant& plant, Axis const& axis, Random& random)
{
    for (std::uint32_t i = 1; i <= axis.segment_count; ++i) {
        Quat orientation
            = rotation_between(Vec3::UnitY(), Vec3(random.normal(), random.normal(), 0.5));
        plant.organs.push_back(
            { .shape = 0,
              .segment = axis.first_segment + i - 1,
              .position_mm = plant.node_position_mm[axis.first_node + i],
              .orientation = orientation,
              .scale = Vec3f::Constant(static_cast<float>(random.uniform(0.6, 1))) });
    }
}

// Returns a broadleaf tree about 4 m high, with three orders of branches. Its trunk and limbs end
// in forks, and its twigs have leaves at their nodes.
inline Plant sample_tree(std::uint64_t seed)
{
    Random random({ .seed = seed });
    Plant plant;
    add_sample_materials(plant);
    append_axis(plant,
                { .segment_mm = 250,
                  .segment_count = 6,
                  .radius_mm = 90,
                  .tip_radius_mm = 55,
                  .bend_rad = 0.06 },
                random);
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        if (plant.axes[id].order < 3)
            add_sample_branches(plant, id, random);
    for (auto const& axis : plant.axes)
        if (axis.order >= 2)
            add_sample_leaves(plant, axis, random);
    return plant;
}

// Returns a plant with a single straight axis along +z.
inline Plant single_axis(std::uint32_t segment_count, double radius_mm, double tip_radius_mm)
{
    Random random({});
    Plant plant;
    plant.materials = { Material {} };
    append_axis(
        plant,
        { .segment_count = segment_count, .radius_mm = radius_mm, .tip_radius_mm = tip_radius_mm },
        random);
    return plant;
}

} // namespace tractus::mesh
