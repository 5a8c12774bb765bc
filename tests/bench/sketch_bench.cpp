// Measures a rule that grows along a stroke: the cost of a pen sample to the station's thread, the
// time until an application of the rule is visible, and the time from pen-up to the finished plant.
#include "app/batch/malloc_tuning.h"
#include "app/methods/all_methods.h"
#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/view/plant_grower.h"
#include "app/view/skeleton_picture.h"
#include "app/view/station_view.h"
#include "app/window/view_curves.h"
#include "engine/methods/sketch_lsystem/rule.h"
#include "tests/app/flat_station.h"
#include "tests/bench/report.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

namespace tractus {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kSegments = 20; // Number of segments in a stroke.

// Returns a rule with two laterals per node. The depth of branching is limited, so that a plant of
// kSegments has about the given number of internodes.
sketch::SketchTool rule_for(std::size_t internodes)
{
    sketch::SketchTool tool { .first_length_mm = 6, .length_ratio = 1, .lateral_length = 0.9 };
    tool.shortest_mm = 0.01;
    tool.surface = StrokeSurface::Space;
    for (double shortest_mm = 5.9; shortest_mm > 0.05; shortest_mm *= 0.97) {
        tool.shortest_mm = shortest_mm;
        sketch::Rule const rule { .first_length_mm = 6,
                                  .length_ratio = 1,
                                  .lateral_length = 0.9,
                                  .shortest_mm = shortest_mm };
        if (sketch::count_internodes(rule, static_cast<int>(kSegments), sketch::kUncutDepth)
            >= static_cast<double>(internodes))
            break;
    }
    return tool;
}

std::vector<TipSample> tips_up(double length_mm)
{
    std::vector<TipSample> tips;
    for (double z_mm = 0; z_mm <= length_mm; z_mm += 0.5)
        tips.push_back({ .position_mm = { 0, 0, z_mm }, .touching = true });
    return tips;
}

double length_mm(sketch::SketchTool const& tool)
{
    return kSegments * tool.first_length_mm + 0.5;
}

// Measures the time of pen samples that do not apply the rule, as the 99th percentile. A stroke is
// drawn at 200 samples a second; samples of its first half second are ignored.
void sketch_sample_p99(benchmark::State& state)
{
    batch::keep_freed_memory(); // The program's window calls this, too.
    constexpr int kSamples = 600;
    constexpr int kFirst = 100;
    auto const tool = rule_for(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        auto station = flat_station(tool);
        document::Document document(scene::Scene {}, document::Document::Working::OnItsThread);
        view::StationView view(station, document);
        std::vector<double> took_s;
        std::uint64_t shown = 0;
        auto next = Clock::now();
        for (int i = 0; i < kSamples; ++i) {
            std::this_thread::sleep_until(next += std::chrono::milliseconds(5));
            auto const begin = Clock::now();
            station.push(kPen, at_ms(5 * i), pen_report(20 + 0.3 * i, 50, true));
            view.show(station, document);
            std::chrono::duration<double> const took = Clock::now() - begin;
            if (view.state().preview_revision == shown && i >= kFirst)
                took_s.push_back(took.count());
            shown = view.state().preview_revision;
        }
        auto const at = static_cast<std::ptrdiff_t>(took_s.size() * 99 / 100);
        std::ranges::nth_element(took_s, took_s.begin() + at);
        state.SetIterationTime(took_s[static_cast<std::size_t>(at)]);
    }
    report(state, { .item = "samples" });
}
BENCHMARK(sketch_sample_p99)->ArgName("internodes")->Arg(20'000)->UseManualTime()->Iterations(3);

// Measures the time from a sample that applies the rule to the lines of the drawing pad and of the
// skeleton.
void sketch_application(benchmark::State& state)
{
    auto const tool = rule_for(static_cast<std::size_t>(state.range(0)));
    // Alternates between strokes with and without the last internode, because the previewer does
    // not repeat an application that it has already shown.
    std::array const inks { tips_up(length_mm(tool)),
                            tips_up(length_mm(tool) - tool.first_length_mm) };
    std::size_t turn = 0;
    auto const scene = std::make_shared<scene::Scene const>();
    auto const previewer = sketch::sketch_previewer();
    tools::Tool const hand = tool;
    view::WindowState seen;
    std::size_t lines = 0;
    for (auto _ : state) {
        seen.preview = previewer->show({ scene, hand, inks[turn++ % 2], 99 });
        benchmark::DoNotOptimize(window::pad_preview_curves(seen).data());
        benchmark::DoNotOptimize(window::preview_curves(seen).data());
        lines = seen.preview.size();
    }
    report(state, { .items = static_cast<double>(lines), .item = "axes" });
}
BENCHMARK(sketch_application)
    ->ArgName("internodes")
    ->Arg(4'000)
    ->Arg(20'000)
    ->Unit(benchmark::kMillisecond);

scene::Scene drawn(sketch::SketchTool const& tool)
{
    Stroke const stroke { tips_up(length_mm(tool)) };
    return scene::apply_edits(scene::Scene {},
                              tools::Tool(tool).edits_for(stroke, scene::Scene {}).value())
        .value();
}

// Measures the time from pen-up to the plant and its skeleton.
void sketch_plant_and_skeleton(benchmark::State& state)
{
    batch::keep_freed_memory();
    auto const tool = rule_for(static_cast<std::size_t>(state.range(0)));
    std::size_t segments = 0;
    for (auto _ : state) {
        auto const scene = std::make_shared<scene::Scene const>(drawn(tool));
        view::SkeletonPicture picture;
        picture.set_scene(scene);
        benchmark::DoNotOptimize(picture.lines({}).data());
        segments = scene->base->segment_count();
    }
    report(state, { .items = static_cast<double>(segments), .item = "segments" });
}
BENCHMARK(sketch_plant_and_skeleton)
    ->ArgName("internodes")
    ->Arg(200'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// Measures the time from the plant to the triangles with leaves.
void sketch_mesh(benchmark::State& state)
{
    batch::keep_freed_memory();
    auto const scene = std::make_shared<scene::Scene const>(
        drawn(rule_for(static_cast<std::size_t>(state.range(0)))));
    view::PlantGrower grower;
    std::size_t triangles = 0;
    for (auto _ : state) {
        grower.grow({ scene, scene->growth });
        std::optional<Result<mesh::Mesh>> mesh;
        while (!(mesh = grower.take()))
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        triangles = (*mesh)->triangle_count();
    }
    report(state, { .items = static_cast<double>(triangles), .item = "triangles" });
}
BENCHMARK(sketch_mesh)
    ->ArgName("internodes")
    ->Arg(200'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace tractus
