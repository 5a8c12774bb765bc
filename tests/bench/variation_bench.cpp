// Growing plants of 131,071 segments, laying strokes along their branches, and the selection pen
// over a skeleton of 100,000 segments.
#include "engine/plant/join_axes.h"
#include "engine/variation/growth.h"
#include "engine/variation/selection.h"
#include "tests/bench/report.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plants.h"

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

std::vector<Association> both(Plant const& plant)
{
    return { { .path = segments_of(plant.axes[0]),
               .stroke = stroke_of(s_curve(200)),
               .propagation = Propagation::Both } };
}

void grow_plants(benchmark::State& state, Plant const& plant, GrowthParameters const& parameters,
                 Vec3 const& influence)
{
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

void GrowBranches(benchmark::State& state)
{
    grow_plants(state, branches(), {}, Vec3::Zero());
}
BENCHMARK(GrowBranches)->UseRealTime()->Unit(benchmark::kMillisecond);

void GrowBranchesInWind(benchmark::State& state)
{
    grow_plants(state, branches(), {}, Vec3(0.5, 0, 0));
}
BENCHMARK(GrowBranchesInWind)->UseRealTime()->Unit(benchmark::kMillisecond);

void GrowTwigs(benchmark::State& state)
{
    grow_plants(state, twigs(), {}, Vec3::Zero());
}
BENCHMARK(GrowTwigs)->UseRealTime()->Unit(benchmark::kMillisecond);

void GrowTwigsInWind(benchmark::State& state)
{
    grow_plants(state, twigs(), {}, Vec3(0.5, 0, 0));
}
BENCHMARK(GrowTwigsInWind)->UseRealTime()->Unit(benchmark::kMillisecond);

void resolve(benchmark::State& state, Plant const& plant)
{
    auto const associations = both(plant);
    for (auto _ : state)
        benchmark::DoNotOptimize(resolve_associations(plant, associations));
    report(state,
           { .items = static_cast<double>(plant.segment_count()),
             .item = "segments",
             .bytes = bytes_of(plant) });
}

void ResolveAssociationOnBranches(benchmark::State& state)
{
    resolve(state, branches());
}
BENCHMARK(ResolveAssociationOnBranches)->UseRealTime()->Unit(benchmark::kMillisecond);

void ResolveAssociationOnTwigs(benchmark::State& state)
{
    resolve(state, twigs());
}
BENCHMARK(ResolveAssociationOnTwigs)->UseRealTime()->Unit(benchmark::kMillisecond);

void PlanGrowth(benchmark::State& state)
{
    auto const shape = resolve_associations(branches(), both(branches())).value();
    for (auto _ : state)
        benchmark::DoNotOptimize(plan_growth(branches(), shape, {}, Vec3::Zero()));
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(PlanGrowth)->UseRealTime()->Unit(benchmark::kMillisecond);

// A window of 1,200 pixels in which the whole tree is seen from the front.
SkeletonView window()
{
    Eigen::Matrix4d clip;
    clip << 1 / 4000., 0, 0, 0, 0, 0, 1 / 4000., 0, 0, 1 / 4000., 0, 0, 0, 0, 0, 1;
    return view_in_pixels(clip, Vec2(1200, 1200));
}

void ProjectSkeleton(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(ProjectedSkeleton(branches(), window()).lines().data());
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(ProjectSkeleton)->UseRealTime()->Unit(benchmark::kMillisecond);

// A pen that crosses the crown at 300 mm/s: 6 pixels between two samples.
void SelectionPenSample(benchmark::State& state)
{
    ProjectedSkeleton const skeleton(branches(), window());
    auto const tree = build_branch_tree(branches());
    PathSelection selection(tree);
    SelectionPen pen(skeleton, selection);
    double x = 300;
    for (auto _ : state) {
        x = x < 900 ? x + 6 : 300;
        benchmark::DoNotOptimize(pen.move_to({ x, 300 + 0.1 * x }));
    }
}
BENCHMARK(SelectionPenSample)->UseRealTime()->Unit(benchmark::kMicrosecond);

} // namespace
} // namespace tractus
