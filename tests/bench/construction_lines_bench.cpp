// From the pen's leaving the tablet after a construction line to the plant that follows it.
#include "engine/methods/construction_lines/line_edits.h"
#include "engine/scene/scene.h"
#include "tests/bench/report.h"

namespace tractus::lines {
namespace {

// Tips 1 mm apart.
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

// A frond without its upper inclination line, that has so many nodes when it is there.
Scene frond(int nodes)
{
    Scene scene;
    auto const draw = [&](std::vector<Vec3> const& corners_mm) {
        scene = apply_edit(scene,
                           AddLine { .plant = scene.state.active,
                                     .stroke = stroke_along(corners_mm),
                                     .nodes = nodes })
                    .value();
    };
    draw({ { 0, -75, 0 }, { 8, 0, 0 }, { 0, 75, 0 } });
    draw({ { -45, -75, 0 }, { -30, 80, 0 } });
    draw({ { 50, -75, 0 }, { 40, 80, 0 } });
    draw({ { -50, -50, 0 }, { 0, -65, 0 }, { 60, -50, 0 } });
    return scene;
}

// The goal is 16 ms at 500 organs.
void follow_line(benchmark::State& state)
{
    auto const organs = state.range(0);
    auto const scene = frond(static_cast<int>(organs / 2 - 1));
    AddLine const line { .plant = scene.state.active,
                         .stroke = stroke_along({ { -50, 90, 0 }, { 2, 60, 0 }, { 60, 90, 0 } }) };
    for (auto _ : state)
        benchmark::DoNotOptimize(apply_edit(scene, line)->base->organs.size());
    report(state, { .items = static_cast<double>(organs), .item = "organs" });
}
BENCHMARK(follow_line)->ArgName("organs")->Arg(20)->Arg(100)->Arg(500)->Arg(1000);

} // namespace
} // namespace tractus::lines
