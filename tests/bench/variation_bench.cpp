// Measures the growth of plants of 131,071 segments, the shaping of larger plants along strokes,
// and the selection pen over a skeleton of a million segments.
#include "engine/plant/join_axes.h"
#include "engine/variation/place_nodes.h"
#include "engine/variation/selection.h"
#include "engine/variation/stroke_shaper.h"
#include "tests/bench/report.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <chrono>
#include <oneapi/tbb/global_control.h>
#include <optional>

namespace tractus {
namespace {

// Returns a plant of 131,071 axes with one segment each. This is the hardest case, since the work
// for each axis is then done for each segment.
Plant const& twigs()
{
    static Plant const plant = variation::forking_tree(17, 1);
    return plant;
}

// Returns a plant of 8,191 axes with sixteen segments each.
Plant const& branches()
{
    static Plant const plant = variation::forking_tree(13, 16);
    return plant;
}

// Returns the bytes of memory that the growth of a plant must at least read and write, as if it
// only copied the plant.
double bytes_of(Plant const& plant)
{
    return static_cast<double>(plant.node_position_mm.size() * sizeof(Vec3)
                               + plant.organs.size() * sizeof(Organ));
}

tbb::global_control limited_to(std::int64_t threads)
{
    return { tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) };
}

std::vector<variation::Association> both(Plant const& plant)
{
    return { { .path = segments_of(plant.axes[0]),
               .stroke = stroke_of(s_curve(200)),
               .propagation = variation::Propagation::Both } };
}

void grow_plants(benchmark::State& state, Plant const& plant,
                 variation::GrowthParameters const& parameters, Vec3 const& influence)
{
    auto const threads = limited_to(state.range(0));
    auto const plan = variation::plan_of(plant, parameters, influence, both(plant));
    variation::Grower grower(plan);
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

// Measures the time from a new association to the positions of all nodes. The user waits for this
// time after a stroke.
void reshape(benchmark::State& state, Plant const& plant)
{
    auto const threads = limited_to(state.range(0));
    auto const associations = both(plant);
    auto const rest = variation::find_rest_shape(plant);
    variation::StrokeShaper shaper(plant, rest);
    std::vector<Vec3> nodes_mm = plant.node_position_mm;
    for (auto _ : state) {
        benchmark::DoNotOptimize(shaper.set(associations));
        variation::place_nodes(plant, rest, shaper.shape(), nodes_mm);
        benchmark::DoNotOptimize(nodes_mm.data());
        state.PauseTiming();
        benchmark::DoNotOptimize(shaper.set({}));
        state.ResumeTiming();
    }
    double const segment_bytes = sizeof(Quat) + sizeof(double) + sizeof(Vec3);
    report(state,
           { .items = static_cast<double>(plant.segment_count()),
             .item = "segments",
             .bytes = segment_bytes * static_cast<double>(plant.segment_count()) });
}

void reshape_twigs(benchmark::State& state)
{
    reshape(state, twigs());
}
BENCHMARK(reshape_twigs)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

// Measures a plant of 50,176 segments: 3,136 axes of sixteen.
void reshape_50_thousand(benchmark::State& state)
{
    static auto const plant = variation::wide_tree(3136, 16);
    reshape(state, plant);
}
BENCHMARK(reshape_50_thousand)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

// Measures a plant of 1,310,704 segments: 81,919 axes of sixteen.
void reshape_1300_thousand(benchmark::State& state)
{
    static auto const plant = variation::wide_tree(81'919, 16);
    reshape(state, plant);
}
BENCHMARK(reshape_1300_thousand)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void find_rest_shape_of_branches(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(variation::find_rest_shape(branches()));
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(find_rest_shape_of_branches)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void plan_growth_of_branches(benchmark::State& state)
{
    auto const rest = variation::find_rest_shape(branches());
    auto const shape = variation::resolve_associations(branches(), rest, both(branches())).value();
    for (auto _ : state)
        benchmark::DoNotOptimize(variation::plan_growth(branches(), rest, shape, {}, {}));
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(plan_growth_of_branches);

// Returns the projection of a window of 1,200 pixels that shows the whole tree from the front.
variation::SkeletonProjection window()
{
    Eigen::Matrix4d clip;
    clip << 1 / 4000., 0, 0, 0, 0, 0, 1 / 4000., 0, 0, 1 / 4000., 0, 0, 0, 0, 0, 1;
    return variation::view_in_pixels(clip, Vec2(1200, 1200));
}

void project_skeleton(benchmark::State& state)
{
    for (auto _ : state)
        benchmark::DoNotOptimize(variation::ProjectedSkeleton(branches(), window()).lines().data());
    report(state,
           { .items = static_cast<double>(branches().segment_count()),
             .item = "segments",
             .bytes = bytes_of(branches()) });
}
BENCHMARK(project_skeleton);

// A skeleton of 1,048,568 segments with all data that the selection pen needs.
struct MillionSegments {
    Plant plant = variation::forking_tree(17, 8);
    variation::BranchTree tree = variation::build_branch_tree(plant);
    variation::ProjectedSkeleton skeleton { plant, window() };
};

MillionSegments& million()
{
    static MillionSegments segments;
    return segments;
}

void turn_view_of_million(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto& segments = million();
    for (auto _ : state)
        segments.skeleton.project(segments.plant, window());
    report(state,
           { .items = static_cast<double>(segments.plant.segment_count()),
             .item = "segments",
             .bytes = bytes_of(segments.plant) });
}
BENCHMARK(turn_view_of_million)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

// Measures the selection pen when a fast hand sweeps through the crown, with 12 pixels and more
// between samples. The time is a percentile of the times of the samples.
void selection_pen_over_million(benchmark::State& state)
{
    auto& segments = million();
    constexpr int kSamples = 4000;
    std::vector<double> seconds;
    for (auto _ : state) {
        seconds.clear();
        variation::PathSelection selection(segments.tree);
        std::optional<variation::SelectionPen> pen;
        for (int i = 0; i < kSamples; ++i) {
            // Begins a new stroke, which runs from the trunk into another part of the crown.
            if (i % 50 == 0) {
                selection.clear();
                pen.emplace(segments.skeleton, segments.tree, selection);
            }
            double const along = (i % 50) * 12;
            double const slope = (i / 50 - 40) / 60.;
            Vec2 const point(600 + slope * along, 600 - along);
            auto const start = std::chrono::steady_clock::now();
            benchmark::DoNotOptimize(pen->move_to(point));
            std::chrono::duration<double> const took = std::chrono::steady_clock::now() - start;
            seconds.push_back(took.count());
        }
        auto const rank = seconds.begin() + kSamples * state.range(0) / 100;
        std::nth_element(seconds.begin(), rank, seconds.end());
        state.SetIterationTime(*rank);
    }
    report(state, { .item = "pen samples" });
}
BENCHMARK(selection_pen_over_million)
    ->ArgName("percent")
    ->Arg(50)
    ->Arg(99)
    ->UseManualTime()
    ->Iterations(20);

} // namespace
} // namespace tractus
