#pragma once

#include "tests/engine/mesh/sample_plants.h"

#include <rapidcheck.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace tractus::mesh {

// Returns a plant with `axis_count` axes of all kinds: straight, bent, of zero length, pointed, and
// thick axes on thin ones. It has segments of several materials, polygons with and without area,
// and organs of two shapes.
inline Plant random_plant(std::uint64_t seed, std::uint32_t axis_count)
{
    Random random({ .seed = seed });
    auto const below = [&](std::uint64_t limit) {
        return static_cast<std::uint32_t>(random.next_u64() % limit);
    };
    Plant plant;
    plant.materials = { {}, { .name = "young", .kind = Material::Kind::Stem }, { .name = "leaf" } };
    plant.organ_shapes = { { .material = 2 }, { .kind = OrganShape::Kind::Ball, .material = 1 } };
    for (AxisId id = 0; id < axis_count; ++id) {
        AxisSketch sketch { .direction = { random.normal(), random.normal(), random.normal() },
                            .segment_mm = below(5) == 0 ? 0 : random.uniform(0.01, 60),
                            .segment_count = 1 + below(12),
                            .radius_mm = random.uniform(0, 20),
                            .tip_radius_mm = below(4) == 0 ? 0 : random.uniform(0, 10),
                            .bend_rad = random.uniform(0, 1.5) };
        if (id > 0 && below(8) > 0) {
            sketch.parent_axis = below(id);
            auto const& parent = plant.axes[sketch.parent_axis];
            auto const segment = below(parent.segment_count);
            sketch.parent_segment = parent.first_segment + segment;
            sketch.base_mm = plant.node_position_mm[parent.first_node + segment + 1];
            sketch.order = parent.order + 1;
        }
        append_axis(plant, sketch, random);
        auto const& axis = plant.axes.back();
        for (std::uint32_t i = 0; i < axis.segment_count; ++i)
            plant.segment_material[axis.first_segment + i]
                = static_cast<MaterialId>(below(6) == 0 ? 1 : 0);
        plant.organs.push_back({ .shape = static_cast<OrganShapeId>(below(2)),
                                 .segment = axis.first_segment,
                                 .position_mm = plant.node_position_mm[axis.first_node + 1] });
        auto const first = static_cast<std::uint32_t>(plant.polygon_vertices_mm.size());
        auto const corners = 3 + below(4);
        for (std::uint32_t i = 0; i < corners; ++i)
            plant.polygon_vertices_mm.emplace_back(random.normal(), random.normal(),
                                                   below(2) * random.normal());
        plant.polygons.push_back(
            { first, corners, axis.first_segment, static_cast<MaterialId>(below(3)) });
    }
    check_plant(plant);
    return plant;
}

// Generates plants with up to a few hundred axes, so that a surface may have more than one parallel
// piece.
inline rc::Gen<Plant> random_plants()
{
    return rc::gen::apply(random_plant, rc::gen::arbitrary<std::uint64_t>(),
                          rc::gen::inRange<std::uint32_t>(0, 400));
}

// Calls `work` with `count` threads for parallel loops, whatever the number of processors is.
template<typename Work> auto on_threads(int count, Work const& work)
{
    tbb::global_control const limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
    return tbb::task_arena(count).execute(work);
}

} // namespace tractus::mesh
