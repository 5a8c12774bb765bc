// Measures the season of two birches with 9,660 leaves: the time from the movement of a slider to
// the triangles of the next picture, and the time after the slider is released, when the leaves are
// regrown at their new age.
#include "app/batch/plant_season.h"
#include "app/view/plant_grower.h"
#include "tests/app/our_plant.h"
#include "tests/bench/report.h"

#include <memory>
#include <thread>

namespace tractus {
namespace {

scene::Scene two_birches()
{
    auto scene = our_plant("birch");
    auto const active = scene.state.active;
    return scene::apply_edit(std::move(scene), scene::CopyPlant { active, { 100, 0, 0 } }).value();
}

// Returns the month of a step; each step advances by half a month.
double month_of(std::size_t step)
{
    return 4.5 + 0.5 * static_cast<double>(step % 12);
}

mesh::Mesh grown(view::PlantGrower& grower, scene::Scene scene)
{
    auto const shared = std::make_shared<scene::Scene const>(std::move(scene));
    grower.grow({ shared, shared->growth });
    for (;;) {
        if (auto mesh = grower.take())
            return *std::move(*mesh);
        std::this_thread::yield();
    }
}

void season_while_a_slider_moves(benchmark::State& state)
{
    auto const scene = two_birches();
    view::PlantGrower grower;
    benchmark::DoNotOptimize(grown(grower, scene).triangle_count());
    std::size_t step = 0;
    for (auto _ : state) {
        auto const seen = scene::preview_in_season(scene, scene::Season { month_of(step++), 0.5 });
        benchmark::DoNotOptimize(grown(grower, seen).triangle_count());
    }
    report(state, { .item = "pictures" });
}
BENCHMARK(season_while_a_slider_moves)->Unit(benchmark::kMillisecond)->UseRealTime();

void season_chosen(benchmark::State& state)
{
    auto const scene = two_birches();
    view::PlantGrower grower;
    std::size_t step = 0;
    for (auto _ : state) {
        auto const there
            = batch::with_season(scene, scene::Season { month_of(step++), 0.5 }).value();
        benchmark::DoNotOptimize(grown(grower, there).triangle_count());
    }
    report(state, { .item = "pictures" });
}
BENCHMARK(season_chosen)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace tractus
