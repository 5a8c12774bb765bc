// Measures the inference of several thousand branches from an outline, the arrangement of branches
// around their parent, and a tree with more than a million leaves.
#include "engine/mesh/make_mesh.h"
#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/chordal_axis.h"
#include "engine/methods/silhouettes/inferred_trees.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/methods/silhouettes/skeleton.h"
#include "engine/methods/silhouettes/tree.h"
#include "tests/bench/report.h"

#include <cmath>
#include <memory>
#include <oneapi/tbb/global_control.h>

namespace tractus::silhouette {
namespace {

// Returns a crown with nine lobes around a trunk.
Drawing crown()
{
    Drawing drawing { { {} }, { Vec2(0, -110), Vec2(0, 55) } };
    for (int i = 0; i < 360; ++i) {
        double const angle = radians(i);
        double const radius_mm = 75 + 16 * std::fabs(std::cos(4.5 * (angle - kPi / 2)));
        drawing.outline[0].emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle));
    }
    return drawing;
}

tbb::global_control limited_to(std::int64_t threads)
{
    return { tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads) };
}

void triangulate_outline(benchmark::State& state)
{
    auto const clean
        = clean_drawing(crown(), { .samples = static_cast<std::size_t>(state.range(0)) });
    for (auto _ : state)
        benchmark::DoNotOptimize(ChordalAxis(clean->outline).triangles().size());
    report(state, { .items = static_cast<double>(state.range(0)), .item = "samples" });
}
BENCHMARK(triangulate_outline)->ArgName("samples")->Arg(128)->Arg(256)->Arg(512);

// Measures the inference of branches at pen-up. Here it infers 4,000 branches on three levels; the
// goal is 16 ms for a thousand.
void infer_branches(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto const drawing = crown();
    std::size_t branches = 0;
    for (auto _ : state) {
        auto const skeleton = infer_skeleton(drawing, { .levels = 3 });
        branches = skeleton->branch_count();
    }
    report(state, { .items = static_cast<double>(branches), .item = "branches" });
}
BENCHMARK(infer_branches)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

Stroke stroke_of(std::vector<Vec2> const& points)
{
    std::vector<TipSample> tips;
    for (auto const& point : points)
        tips.push_back({ .position_mm = { point.x(), point.y(), 0 } });
    return { std::move(tips) };
}

// Measures pen-up after the crown of an existing tree was redrawn three per cent wider. Branches
// keep their names, and the inferred branches replace those of the tree. The goal is 16 ms for a
// thousand branches.
void change_outline(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto const drawing = crown();
    auto wider = drawing.outline[0];
    for (auto& point : wider)
        point.x() *= 1.03;
    OutlinedTree before { .trunk = stroke_of(drawing.trunk),
                          .outline = stroke_of(drawing.outline[0]),
                          .inferred = std::make_shared<InferredTrees>() };
    before.form.levels = 3;
    if (!inferred(before)) {
        state.SkipWithError("the tree cannot be inferred");
        return;
    }
    std::size_t branches = 0;
    for (auto _ : state) {
        auto after = before;
        after.outline = stroke_of(wider);
        if (!keep_names(before, after, "n"))
            state.SkipWithError("the tree has no names");
        branches = (*inferred(after))->skeleton.branch_count();
    }
    report(state, { .items = static_cast<double>(branches), .item = "branches" });
}
BENCHMARK(change_outline)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void arrange_branches(benchmark::State& state)
{
    auto const count = static_cast<std::size_t>(state.range(0));
    std::uint64_t seed = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(arrange({}, { .count = count }, { .seed = ++seed }).cost_after);
    report(state, { .items = 3000, .item = "proposals" });
}
BENCHMARK(arrange_branches)->ArgName("branches")->Arg(12)->Arg(30)->Arg(60)->Arg(200);

// Measures making a tree of 1.3 million elements, and the mesh that a view draws of it.
void make_large_tree(benchmark::State& state)
{
    auto const threads = limited_to(state.range(0));
    auto const skeleton = infer_skeleton(crown());
    TreeOptions const options { .levels = { { .added = 0.5 }, { .added = 0.3, .proposals = 600 } },
                                .sprays = 24,
                                .leaf = { .per_spray = 60 } };
    double elements = 0;
    for (auto _ : state) {
        auto const tree = make_tree(*skeleton, options);
        elements = static_cast<double>(tree.element_count());
        benchmark::DoNotOptimize(mesh::make_organs(tree.plant).size());
    }
    report(state, { .items = elements, .item = "elements" });
}
BENCHMARK(make_large_tree)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

} // namespace
} // namespace tractus::silhouette
