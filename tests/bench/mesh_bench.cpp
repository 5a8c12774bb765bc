// Measures meshing the monopodial tree of ABoP figure 2.6, writing it as .glb, and writing a
// collection of plants.
//
// Files are written to the folder of temporary files, into the page cache. The program cp, whose
// time is the limit, does the same: neither program waits for the disk, and neither overwrites an
// existing file.
#include "engine/export/glb_writer.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "engine/mesh/make_mesh.h"
#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"
#include "tests/engine/mesh/sample_plants.h"
#include "tests/engine/variation/plans.h"

#include <cstring>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <oneapi/tbb/global_control.h>
#include <unistd.h>

namespace tractus {
namespace {

constexpr int kSteps = 20; // Number of derivation steps; 20 make 1,048,575 segments.

Plant const& plant()
{
    static Plant const made = [] {
        lsystem::ModelSource source;
        source.text = kMonopodialTree;
        auto const model = lsystem::compile_model(source).value();
        lsystem::DeriveOptions options;
        options.steps = kSteps;
        return lsystem::interpret(model, lsystem::derive(model, options).value()).value();
    }();
    return made;
}

// Options for tubes of sixteen triangles per segment and nothing else, as published for other
// programs.
constexpr mesh::MeshOptions kBareTubes { .min_sides = 8,
                                         .max_sides = 8,
                                         .subdivision = 0,
                                         .collar = 0,
                                         .ends = mesh::MeshOptions::Ends::Open };

// Limits the number of threads to the benchmark's argument.
class Threads {
public:
    explicit Threads(benchmark::State const& state)
        : control_(tbb::global_control::max_allowed_parallelism,
                   static_cast<std::size_t>(state.range(0)))
    {
    }

private:
    tbb::global_control control_;
};

constexpr std::size_t kCollectionPlants = 200;
constexpr std::size_t kCollectionSegments = 10000;
constexpr std::size_t kCollectionLeaves = 5000;

// Returns the plant of which the collection has variations. Its axes have eight segments each and
// start at nodes of earlier axes; the last axes have leaves.
Plant collected_plant()
{
    Random random({ .seed = 1 });
    Plant plant;
    plant.materials = { {}, { .name = "leaf", .kind = Material::Kind::Leaf } };
    plant.organ_shapes = { { .material = 1 } };
    mesh::append_axis(plant, { .segment_count = 8, .radius_mm = 90, .bend_rad = 0.1 }, random);
    for (AxisId id = 0; plant.segment_count() < kCollectionSegments; ++id) {
        auto const parent = plant.axes[id];
        for (std::uint32_t i = 0; i < 8 && plant.segment_count() < kCollectionSegments; ++i) {
            NodeId const node = parent.first_node + i + 1;
            double const radius_mm = 0.7 * static_cast<double>(plant.node_radius_mm[node]);
            mesh::append_axis(plant,
                              { .base_mm = plant.node_position_mm[node],
                                .direction = { random.normal(), random.normal(), random.normal() },
                                .segment_mm = 150.0 / (2 + parent.order),
                                .segment_count = 8,
                                .radius_mm = radius_mm,
                                .tip_radius_mm = 0.4 * radius_mm,
                                .bend_rad = 0.1,
                                .parent_segment = parent.first_segment + i,
                                .parent_axis = id,
                                .order = parent.order + 1 },
                              random);
        }
    }
    for (std::size_t i = 0; i < kCollectionLeaves; ++i) {
        auto const segment = static_cast<SegmentId>(plant.segment_count() - 1 - i);
        plant.organs.push_back(
            { .segment = segment,
              .position_mm = plant.node_position_mm[nodes_of(plant, segment).tip],
              .orientation = Quat(random.normal(), random.normal(), random.normal(), 1) });
    }
    return plant;
}

template<typename Use> void for_each_array(mesh::Mesh& mesh, Use const& use)
{
    for (auto& surface : mesh.surfaces) {
        use(surface.positions_mm);
        use(surface.normals);
        use(surface.texture_coordinates);
        use(surface.indices);
    }
}

double bytes_of(mesh::Mesh& mesh)
{
    double bytes = 0;
    for_each_array(mesh, [&](auto const& array) {
        bytes += static_cast<double>(array.size() * sizeof array[0]);
    });
    return bytes;
}

void make_mesh_bench(benchmark::State& state, mesh::MeshOptions const& options)
{
    Threads const threads(state);
    mesh::Mesh mesh;
    for (auto _ : state) {
        mesh = {}; // Frees the memory, so that every run allocates it anew.
        mesh = mesh::make_mesh(plant(), options);
    }
    report(state,
           { .items = static_cast<double>(mesh.triangle_count()),
             .item = "triangles",
             .bytes = bytes_of(mesh),
             .limit = Limit::Fill });
}

// Fills arrays of the same size as those of bare tubes by memset. Every run allocates them anew.
void fill_arrays_of_bare_tubes(benchmark::State& state)
{
    mesh::Mesh const mesh = mesh::make_mesh(plant(), kBareTubes);
    mesh::Mesh filled;
    for (auto _ : state) {
        filled = {};
        for (auto const& surface : mesh.surfaces) {
            auto& arrays = filled.surfaces.emplace_back();
            arrays.positions_mm.resize(surface.positions_mm.size());
            arrays.normals.resize(surface.normals.size());
            arrays.texture_coordinates.resize(surface.texture_coordinates.size());
            arrays.indices.resize(surface.indices.size());
        }
        for_each_array(filled, [](auto& array) {
            std::memset(static_cast<void*>(array.data()), 1, array.size() * sizeof array[0]);
        });
        benchmark::ClobberMemory();
    }
    report(state,
           { .items = static_cast<double>(mesh.triangle_count()),
             .item = "triangles",
             .bytes = bytes_of(filled),
             .limit = Limit::Fill });
}

void write_glb_bench(benchmark::State& state, std::span<exports::PlacedMesh const> plants,
                     exports::GlbOptions const& options = {})
{
    Threads const threads(state);
    auto const path
        = std::filesystem::temp_directory_path() / fmt::format("tractus-bench-{}.glb", ::getpid());
    std::uint64_t bytes = 0;
    for (auto _ : state) {
        state.PauseTiming();
        std::filesystem::remove(path);
        state.ResumeTiming();
        std::ofstream out(path, std::ios::binary);
        auto const summary = exports::write_glb(out, plants, options);
        if (!summary) {
            state.SkipWithError(summary.error().message.c_str());
            break;
        }
        bytes = summary->bytes;
    }
    report(state,
           { .items = static_cast<double>(bytes),
             .item = "bytes",
             .bytes = static_cast<double>(bytes),
             .limit = Limit::Cp,
             .file = path });
    std::filesystem::remove(path);
}

void make_mesh_of_bare_tubes(benchmark::State& state)
{
    make_mesh_bench(state, kBareTubes);
}
void make_mesh_of_eight_sides(benchmark::State& state)
{
    make_mesh_bench(state, { .min_sides = 8, .max_sides = 8, .subdivision = 0, .collar = 0 });
}
void make_mesh_for_pictures(benchmark::State& state)
{
    make_mesh_bench(state, {});
}
void write_glb_of_a_mesh(benchmark::State& state)
{
    mesh::Mesh const mesh = mesh::make_mesh(plant(), kBareTubes);
    exports::PlacedMesh const placed { .mesh = &mesh };
    write_glb_bench(state, std::span(&placed, 1));
}
void write_glb_while_meshing(benchmark::State& state)
{
    exports::PlacedMesh const placed { .mesh = exports::PlantToMesh { .plant = &plant(),
                                                                      .options = kBareTubes } };
    write_glb_bench(state, std::span(&placed, 1));
}

// Writes 200 plants of 10,000 segments and 5,000 leaves. Each plant is grown when its turn comes.
void write_glb_of_a_collection(benchmark::State& state)
{
    auto const plan = variation::plan_of(collected_plant(), {});
    variation::Grower grower(plan);
    std::vector<exports::PlacedMesh> plants(kCollectionPlants);
    for (std::uint32_t i = 0; i < plants.size(); ++i)
        plants[i].mesh = exports::PlantToMesh { .plant =
                                                    [&, i] {
                                                        return grower.grow({ 1, i });
                                                    },
                                                .options = { .min_sides = 8, .max_sides = 8 } };
    write_glb_bench(state, plants, { .vertices = exports::GlbOptions::Vertices::Quantized });
}

void on_threads(benchmark::internal::Benchmark* bench)
{
    bench->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(fill_arrays_of_bare_tubes)->UseRealTime();
BENCHMARK(make_mesh_of_bare_tubes)->Apply(on_threads);
BENCHMARK(make_mesh_of_eight_sides)->Apply(on_threads);
BENCHMARK(make_mesh_for_pictures)->Apply(on_threads);
BENCHMARK(write_glb_of_a_mesh)->Apply(on_threads);
BENCHMARK(write_glb_while_meshing)->Apply(on_threads);
BENCHMARK(write_glb_of_a_collection)->Apply(on_threads);

} // namespace
} // namespace tractus
