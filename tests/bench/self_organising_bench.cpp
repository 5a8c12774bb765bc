// Measures self-organising trees: the growth of a large tree in a year, a step of the brush among
// many markers, and the growth of a whole life.
#include "engine/base/random.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "tests/bench/report.h"

#include <oneapi/tbb/global_control.h>

namespace tractus::self_organising {
namespace {

tbb::global_control limited_to(std::int64_t threads)
{
    return { tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) };
}

// Returns the habit of an oak in the open.
Habit oak()
{
    return { .name = "oak",
             .internode_mm = 95,
             .vigour = 3,
             .vigour_old = 2.5,
             .apical_control = 0.62,
             .apical_control_old = 0.49,
             .terminal_loss = 0.2,
             .angle_deg = 55,
             .lateral_angle_deg = 55,
             .divergence_deg = 144,
             .lateral_divergence_deg = 144,
             .tropism_trunk = 0.2,
             .tropism_branches = 0.07,
             .tropism_twigs = 0.07,
             .tropism_last = 0.07,
             .cell_mm = 195,
             .shade = 0.12,
             .shade_fall = 2.8,
             .shade_depth = 5,
             .shed_below = 0.15,
             .shed_below_old = 0.15,
             .clear_share = 0.1,
             .pipe_exponent = 2.2,
             .weight = 0.08,
             .leaf_years = 2,
             .leaves_at_node = 4 };
}

// Returns the tree at the age at which it has the given number of internodes.
GrowingTree oak_of(std::size_t internodes)
{
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings;
    while (tree.size() < internodes && tree.step < kMaxYears)
        if (!grow_year(tree, surroundings, oak()))
            break;
    return tree;
}

// Measures a year of growth. The goal is 100 ms for 100,000 internodes.
void grow_a_year(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto const tree = oak_of(100'000);
    for (auto _ : state) {
        state.PauseTiming();
        auto older = tree;
        Surroundings surroundings;
        state.ResumeTiming();
        benchmark::DoNotOptimize(grow_year(older, surroundings, oak()));
    }
    report(state, { .items = static_cast<double>(tree.size()), .item = "internodes" });
}
BENCHMARK(grow_a_year)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

// Measures a step of the brush among the buds of a grown oak and a million markers; the goal is 16
// ms.
void step_of_brush(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto const tree = oak_of(100'000);
    std::vector<Vec3> markers;
    Random random({ .seed = 1 });
    for (int i = 0; i < 1'000'000; ++i)
        markers.emplace_back(random.uniform(-9000, 9000), random.uniform(-9000, 9000),
                             random.uniform(0, 20'000));
    auto const laws = brush_growth_laws(oak(), tree.step + 1, oak().internode_mm);
    Vec3 const tip = tree.places.back().position;
    for (auto _ : state) {
        state.PauseTiming();
        auto brushed = tree;
        Surroundings surroundings { .markers = markers, .region = Region { tip, 900 } };
        state.ResumeTiming();
        benchmark::DoNotOptimize(grow_step(brushed, surroundings, laws));
    }
    report(state, { .items = static_cast<double>(living_buds(tree).size()), .item = "buds" });
}
BENCHMARK(step_of_brush)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

// Measures growth from the seedling to the plant with its leaves; the goal is 2 s for 300,000
// internodes.
void grow_a_life(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    std::size_t internodes = 0;
    for (auto _ : state) {
        auto const tree = grow_without_brush(oak(), 52, 1);
        if (!tree) {
            state.SkipWithError(tree.error().message.c_str());
            return;
        }
        internodes = plant_of(*tree, oak(), 1).plant.segment_count();
    }
    report(state, { .items = static_cast<double>(internodes), .item = "internodes" });
}
BENCHMARK(grow_a_life)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace tractus::self_organising
