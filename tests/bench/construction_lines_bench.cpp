// Measures the time from pen-up after a construction line to the resulting plant.
#include "engine/methods/construction_lines/composed_model.h"
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/scene/scene.h"
#include "tests/bench/report.h"

namespace tractus::lines {
namespace {

// Returns a stroke along a polyline, with tips 1 mm apart.
Stroke stroke_along(std::vector<Vec3> const& corners_mm)
{
    Stroke stroke;
    for (std::size_t i = 1; i < corners_mm.size(); ++i) {
        Vec3 const way_mm = corners_mm[i] - corners_mm[i - 1];
        int const pieces = static_cast<int>(way_mm.norm()) + 1;
        for (int k = 0; k <= pieces; ++k)
            stroke.tips.push_back(
                { .position_mm = corners_mm[i - 1] + way_mm * k / pieces, .touching = true });
    }
    return stroke;
}

// Returns the uppermost inclination line of a frond.
Stroke top_line()
{
    return stroke_along({ { -50, 90, 0 }, { 2, 60, 0 }, { 60, 90, 0 } });
}

// Returns a frond without its uppermost inclination line. Once that line is added, the frond's
// layers have the given number of nodes.
scene::Scene frond(int nodes, int layers = 1)
{
    scene::Scene scene;
    auto const draw = [&](std::vector<Vec3> const& corners_mm) {
        scene = scene::apply_edit(scene,
                                  AddLine { .plant = scene.state.active,
                                            .stroke = stroke_along(corners_mm),
                                            .nodes = nodes })
                    .value();
    };
    draw({ { 0, -75, 0 }, { 8, 0, 0 }, { 0, 75, 0 } });
    draw({ { -45, -75, 0 }, { -30, 80, 0 } });
    draw({ { 50, -75, 0 }, { 40, 80, 0 } });
    for (int i = 0; i < layers; ++i) {
        double const rise = 125.0 * i / layers;
        draw({ { -50, -50 + rise, 0 }, { 4, -65 + rise, 0 }, { 60, -50 + rise, 0 } });
    }
    return scene;
}

void follow(benchmark::State& state, scene::Scene const& scene)
{
    AddLine const line { .plant = scene.state.active, .stroke = top_line() };
    std::size_t organs = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(organs = scene::apply_edit(scene, line)->base->organs.size());
    report(state, { .items = static_cast<double>(organs), .item = "organs" });
}

// Measures the plant following a line, with a given number of organs. The goal is 16 ms for 500
// organs.
void follow_line(benchmark::State& state)
{
    follow(state, frond(static_cast<int>(state.range(0) / 2 - 1)));
}
BENCHMARK(follow_line)->ArgName("organs")->Arg(20)->Arg(100)->Arg(500)->Arg(1000);

// Measures the plant following a line, with leaves that are drawn in three views. The goal is 16 ms
// for 500 organs.
void follow_line_with_drawn_leaves(benchmark::State& state)
{
    auto scene = frond(static_cast<int>(state.range(0) / 2 - 1));
    auto const draw = [&](OrganView view, std::vector<Vec3> const& corners_mm) {
        auto const& organs = active_pen_sketch(scene.state)->organs;
        scene = scene::apply_edit(scene,
                                  DrawOrgan { .plant = scene.state.active,
                                              .organ = organs.empty() ? 0 : organs.front().id,
                                              .view = view,
                                              .stroke = stroke_along(corners_mm) })
                    .value();
    };
    draw(OrganView::Side, { { 80, 0, 0 }, { 95, 20, 0 }, { 90, 40, 0 }, { 80, 60, 0 } });
    draw(OrganView::Midrib, { { 80, 0, 0 }, { 100, 12, 0 }, { 120, 10, 0 }, { 140, 0, 0 } });
    draw(OrganView::Section, { { 80, 8, 0 }, { 90, 0, 0 }, { 100, 8, 0 } });
    follow(state, scene);
}
BENCHMARK(follow_line_with_drawn_leaves)->ArgName("organs")->Arg(500);

// Measures the plant following a line of a stem with ten layers. The goal is 100 ms for 10,000
// organs.
void follow_line_of_ten_layers(benchmark::State& state)
{
    follow(state, frond(static_cast<int>(state.range(0) / 20 - 1), 10));
}
BENCHMARK(follow_line_of_ten_layers)->ArgName("organs")->Arg(2'000)->Arg(10'000);

// Returns the measurements of a stem with boundaries and two inclination lines.
Construction sprig(int nodes)
{
    return measure_sketch({ .stem = { { 0, 0, 0 }, { 0, 100, 0 } },
                            .left = { { -30, 0 }, { -20, 100 } },
                            .right = { { 30, 0 }, { 20, 100 } },
                            .inclinations = { { { -40, 25 }, { 0, 5 }, { 40, 25 } },
                                              { { -40, 115 }, { 0, 95 }, { 40, 115 } } },
                            .nodes_per_layer = { nodes } })
        .value();
}

std::shared_ptr<Plant const> plant_of(LineModel const& model)
{
    scene::LoadModel const load { .source = model.source, .includes = model.functions };
    return scene::apply_edit(scene::Scene {}, load).value().base;
}

// Measures the composition of sketches that are organs of a sketch: from the measured lines to the
// plant, including the model's text and its derivation. The goal is 100 ms for a sketch with 100
// organs of 100 organs each.
void compose_sketches(benchmark::State& state)
{
    auto const nodes = static_cast<int>(state.range(0)) / 2;
    auto const leaf = std::make_shared<ComposedSketch const>(
        ComposedSketch { .stems = { { .construction = sprig(nodes - 1) } } });
    ComposedSketch sketch { .stems = { { .construction = sprig(nodes - 1) } },
                            .organs = { { .sketch = leaf } } };
    sketch.stems.front().construction.organs_per_layer = { { .organ = 1 } };
    std::size_t organs = 0;
    for (auto _ : state) {
        auto const model = write_composed_model(sketch, "composed").value();
        organs = plant_of(model)->organs.size();
    }
    report(state, { .items = static_cast<double>(organs), .item = "organs" });
}
BENCHMARK(compose_sketches)->ArgName("organs_of_each")->Arg(100)->UseRealTime();

} // namespace
} // namespace tractus::lines
