// Growing plants of 131,071 segments, laying strokes along their branches, and the selection pen
// over a skeleton of 100,000 segments.
#include "engine/plant/join_axes.h"
#include "engine/variation/growth.h"
#include "engine/variation/selection.h"
#include "tests/bench/report.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plants.h"

#include <oneapi/tbb/global_control.h>

namespace tractus {
namespace {

// 131,071 axes of one segment: the hardest case, since all that is done per axis is done per
// segment.
Plant const& twigs()
{
    static Plant const plant = forking_tree(17, 1);
    return plant;
}

// 8,191 axes of sixteen segments.
Plant const& branches()
{
    static Plant const plant = forking_tree(13, 16);
    return plant;
}

// What one plant's growth reads and writes of memory when it is copied and nothing else.
double bytes_of(Plant const& plant)
{
    return static_cast<double>(plant.node_position_mm.size() * sizeof(Vec3)
                               + plant.organs.size() * sizeof(Organ));
}

tbb::global_control limited_to(std::int64_t threads)
{
    return { tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) };
}

std::vector<Association> both(Plant const& plant)
{
    return { { .path = segments_of(plant.axes[0]),
               .stroke = stroke_of(s_curve(200)),
               .propagation = Propagation::Both } };
}

void grow_plants(benchmark::State& state, Plant const& plant, GrowthParameters const& parameters,
                 Vec3 const& influence)
{
    auto const threads = limited_to(state.range(0));
    auto const shape = resolve_associations(plant, both(plant)).value();
    auto const plan = plan_growth(plant, shape, parameters, influence).value();
    Grower grower(plan);
    std::uint32_t index = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(&grower.grow({ .seed = 1, .plant_index = index++ }));
    report(state,
           { .items = static_cast<double>(plant.segment_count()),
             .item = "segments",
             .bytes = bytes_of(plant) });
}

void grow_branches(benchmark::State& state)
{
    grow_plants(state, branches(), {}, Vec3::Zero());
}
BENCHMARK(grow_branches)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void grow_branches_in_wind(benchmark::State& state)
{
    grow_plants(state, branches(), {}, Vec3(0.5, 0, 0));
}
BENCHMARK(grow_branches_in_wind)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void grow_twigs(benchmark::State& state)
{
    grow_plants(state, twigs(), {}, Vec3::Zero());
}
BENCHMARK(grow_twigs)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void grow_twigs_in_wind(benchmark::State& state)
{
    grow_plants(state, twigs(), {}, Vec3(0.5, 0, 0));
}
BENCHMARK(grow_twigs_in_wind)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void resolve(benchmark::State& state, Plant const& plant)
{
    auto const threads = limited_to(state.range(0));
    auto const associations = both(plant);
    for (auto _ : state)
        benchmark::DoNotOptimize(resolve_associations(plant, associations));
    report(state,
           { .items = static_cast<double>(plant.segment_count()),
             .item = "segments",
             .bytes = bytes_of(plant) });
}

void resolve_on_branches(benchmark::State& state)
{
    resolve(state, branches());
}
BENCHMARK(resolve_on_branches)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void resolve_on_twigs(benchmark::State& state)
{
    resolve(state, twigs());
}
BENCHMARK(resolve_on_twigs)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void plan_growth_of_branches(benchmark::State& state)
{
    auto const shape = resolve_associations(branches(), both(branches())).value();
    for (auto _ : state)
        benchmark::DoNotOptimize(plan_growth(branches(), shape, {}, Vec3::Zero()));
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(plan_growth_of_branches);

// A window of 1,200 pixels in which the whole tree is seen from the front.
SkeletonProjection window()
{
    Eigen::Matrix4d clip;
    clip << 1 / 4000., 0, 0, 0, 0, 0, 1 / 4000., 0, 0, 1 / 4000., 0, 0, 0, 0, 0, 1;
    return view_in_pixels(clip, Vec2(1200, 1200));
}

void project_skeleton(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(ProjectedSkeleton(branches(), window()).lines().data());
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(project_skeleton);

// A pen that crosses the crown at 300 mm/s: 6 pixels between two samples.
void move_selection_pen(benchmark::State& state)
{
    ProjectedSkeleton const skeleton(branches(), window());
    auto const tree = build_branch_tree(branches());
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection);
    double x = 300;
    for (auto _ : state) {
        x = x < 900 ? x + 6 : 300;
        benchmark::DoNotOptimize(pen.move_to({ x, 300 + 0.1 * x }));
    }
    report(state, { .item = "pen samples" });
}
BENCHMARK(move_selection_pen);

} // namespace
} // namespace tractus
