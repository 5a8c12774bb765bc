// Meshing a plant of 131,071 segments, and writing it as .glb.
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "tests/bench/report.h"
#include "tests/engine/mesh/sample_plants.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <oneapi/tbb/global_control.h>
#include <streambuf>
#include <unistd.h>

namespace tractus {
namespace {

constexpr std::size_t kSegmentCount = 131071;

// Axes of eight segments on every node of earlier ones, until there are enough.
Plant large_plant()
{
    Random random({ .seed = 1 });
    Plant plant;
    plant.materials = { Material {} };
    append_axis(plant,
                { .segment_mm = 200,
                  .segment_count = 8,
                  .radius_mm = 200,
                  .tip_radius_mm = 50,
                  .bend_rad = 0.1 },
                random);
    for (AxisId id = 0; plant.segment_count() < kSegmentCount; ++id) {
        auto const parent = plant.axes[id];
        for (std::uint32_t i = 0; i < parent.segment_count && plant.segment_count() < kSegmentCount;
             ++i) {
            NodeId const node = parent.first_node + i + 1;
            double const radius = plant.node_radius_mm[node];
            Vec3 const out(random.normal(), random.normal(), random.normal());
            auto const left = static_cast<std::uint32_t>(kSegmentCount - plant.segment_count());
            append_axis(plant,
                        { .base_mm = plant.node_position_mm[node],
                          .direction = out,
                          .segment_mm = 200.0 / (2 + parent.order),
                          .segment_count = std::min(8u, left),
                          .radius_mm = 0.7 * radius,
                          .tip_radius_mm = 0.3 * radius,
                          .bend_rad = 0.1,
                          .parent_segment = parent.first_segment + i,
                          .parent_axis = id,
                          .order = parent.order + 1 },
                        random);
        }
    }
    return plant;
}

Plant const& plant()
{
    static Plant const made = large_plant();
    return made;
}

// Sixteen triangles a segment, as other programs' figures are counted.
constexpr MeshOptions kEightSides { .min_sides = 8, .max_sides = 8, .subdivision = 0, .collar = 0 };

double bytes_of(Mesh const& mesh)
{
    double bytes = 0;
    for (auto const& surface : mesh.surfaces)
        bytes += static_cast<double>(surface.positions_mm.size() * 8 * sizeof(float)
                                     + surface.indices.size() * sizeof(std::uint32_t));
    return bytes;
}

void make_mesh_bench(benchmark::State& state, MeshOptions const& options)
{
    tbb::global_control const threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(state.range(0)));
    Mesh mesh;
    for (auto _ : state) {
        mesh = {}; // Every run pays for its memory, as the first one does.
        mesh = make_mesh(plant(), options);
    }
    report(state,
           { .items = static_cast<double>(mesh.triangle_count()),
             .item = "triangles",
             .bytes = bytes_of(mesh),
             .limit = Limit::Fill });
}

// A stream into memory that is there already.
class MemoryStream : public std::streambuf {
public:
    explicit MemoryStream(std::size_t size)
        : bytes_(size, 1)
    {
        setp(bytes_.data(), bytes_.data() + bytes_.size());
    }

protected:
    std::streamsize xsputn(char const* bytes, std::streamsize count) override
    {
        auto const size = static_cast<std::size_t>(count);
        if (at_ + size > bytes_.size())
            return 0;
        std::copy(bytes, bytes + count, bytes_.data() + at_);
        at_ += size;
        return count;
    }
    pos_type seekoff(off_type offset, std::ios_base::seekdir, std::ios_base::openmode) override
    {
        return static_cast<pos_type>(static_cast<off_type>(at_) + offset);
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode) override
    {
        at_ = static_cast<std::size_t>(static_cast<off_type>(position));
        return position;
    }

private:
    std::vector<char> bytes_;
    std::size_t at_ = 0;
};

void write_glb_bench(benchmark::State& state, Limit limit)
{
    Mesh const mesh = make_mesh(plant(), kEightSides);
    PlacedMesh const placed { .mesh = &mesh };
    auto const path
        = std::filesystem::temp_directory_path() / fmt::format("tractus-bench-{}.glb", ::getpid());
    MemoryStream memory(limit == Limit::Copy ? glb_bytes(mesh) + 1000000 : 0);
    std::uint64_t bytes = 0;
    for (auto _ : state) {
        std::ofstream file;
        if (limit == Limit::Disk)
            file.open(path, std::ios::binary | std::ios::trunc);
        std::ostream out(limit == Limit::Disk ? static_cast<std::streambuf*>(file.rdbuf())
                                              : &memory);
        out.seekp(0);
        auto const summary = write_glb(out, std::span(&placed, 1));
        if (!summary) {
            state.SkipWithError(summary.error().message.c_str());
            break;
        }
        bytes = summary->bytes;
    }
    std::filesystem::remove(path);
    report(state,
           { .items = static_cast<double>(bytes),
             .item = "bytes",
             .bytes = static_cast<double>(bytes),
             .limit = limit });
}

void make_mesh_of_eight_sides(benchmark::State& state)
{
    make_mesh_bench(state, kEightSides);
}
void make_mesh_for_pictures(benchmark::State& state)
{
    make_mesh_bench(state, {});
}
void write_glb_to_memory(benchmark::State& state)
{
    write_glb_bench(state, Limit::Copy);
}
void write_glb_to_disk(benchmark::State& state)
{
    write_glb_bench(state, Limit::Disk);
}

BENCHMARK(make_mesh_of_eight_sides)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(make_mesh_for_pictures)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();
BENCHMARK(write_glb_to_memory)->UseRealTime();
BENCHMARK(write_glb_to_disk)->UseRealTime();

} // namespace
} // namespace tractus
