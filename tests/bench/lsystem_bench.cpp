#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/fast_drawing/interpret.h"
#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"

#include <oneapi/tbb/global_control.h>
#include <string>
#include <vector>

namespace tractus {
namespace {

// Models with which other L-system engines have been measured in publications.

// ABoP figure 1.24a: 2.5 * 5^n - 1.5 modules after n steps.
constexpr char const* kBush
    = "Lsystem: 1\nderivation length: 10\nAxiom: F\nF --> F[+F]F[-F]F\nendlsystem\n";

// ABoP figure 1.31a: contexts across brackets.
constexpr char const* kSignals = R"(Lsystem: 1
derivation length: 30
ignore: +-F
Axiom: F1F1F1
0<0>0 --> 0
0<0>1 --> 1[+F1F1]
0<1>0 --> 1
0<1>1 --> 1
1<0>0 --> 0
1<0>1 --> 1F1
1<1>0 --> 0
1<1>1 --> 0
+ --> -
- --> +
endlsystem
)";

std::string row_of_signals()
{
    return "Lsystem: 1\nderivation length: 100\nAxiom: B" + std::string(20'000, 'A')
        + "\nB < A --> B\nB --> A\nendlsystem\n";
}

// Limits the number of threads to the benchmark's second argument.
tbb::global_control limited_threads(benchmark::State const& state)
{
    return { tbb::global_control::max_allowed_parallelism,
             static_cast<std::size_t>(state.range(1)) };
}

lsystem::Model compiled(std::string const& rules)
{
    lsystem::ModelSource source;
    source.text = rules;
    return lsystem::compile_model(source).value();
}

// Measures the derivation of a model. The bytes are those of the last string, read or written once,
// because the strings of earlier steps are much shorter.
void derive_model(benchmark::State& state, std::string const& rules)
{
    auto const threads = limited_threads(state);
    auto const model = compiled(rules);
    lsystem::DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    std::size_t modules = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        auto const string = lsystem::derive(model, options).value();
        modules = string.size();
        bytes = string.kinds.size() + string.parameters.size() * sizeof(float);
        benchmark::DoNotOptimize(string.kinds.data());
    }
    report(state,
           { .items = static_cast<double>(modules),
             .item = "modules",
             .bytes = static_cast<double>(bytes),
             .limit = Limit::Fill });
}

void derive_bush(benchmark::State& state)
{
    derive_model(state, kBush);
}
void derive_tree(benchmark::State& state)
{
    derive_model(state, kMonopodialTree);
}
void derive_signals(benchmark::State& state)
{
    derive_model(state, kSignals);
}

void signal_through_a_row(benchmark::State& state)
{
    auto const threads = limited_threads(state);
    auto const model = compiled(row_of_signals());
    lsystem::DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(lsystem::derive(model, options).value().kinds.data());
    double const module_steps = 20'001.0 * static_cast<double>(state.range(0));
    report(state, { .items = module_steps, .item = "module steps", .bytes = 2 * module_steps });
}

void compile_tree(benchmark::State& state)
{
    lsystem::ModelSource source;
    source.text = kMonopodialTree;
    for (auto _ : state)
        benchmark::DoNotOptimize(lsystem::compile_model(source).value());
    report(state,
           { .items = 1, .item = "models", .bytes = static_cast<double>(source.text.size()) });
}

void interpret_tree(benchmark::State& state)
{
    auto const threads = limited_threads(state);
    auto const model = compiled(kMonopodialTree);
    lsystem::DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    auto const string = lsystem::derive(model, options).value();
    std::size_t segments = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        auto const plant = lsystem::interpret(model, string).value();
        segments = plant.segment_count();
        bytes = plant.node_position_mm.size() * (sizeof(Vec3) + sizeof(float))
            + segments * sizeof(MaterialId) + plant.axes.size() * sizeof(Axis);
        benchmark::DoNotOptimize(plant.axes.data());
    }
    report(state,
           { .items = static_cast<double>(segments),
             .item = "segments",
             .bytes = static_cast<double>(bytes),
             .limit = Limit::Fill });
}

// Registers each number of steps with one thread and with two threads.
void for_steps(benchmark::internal::Benchmark* bench, std::vector<std::int64_t> const& steps)
{
    bench->ArgNames({ "", "threads" })
        ->ArgsProduct({ steps, { 1, 2 } })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
}

BENCHMARK(derive_bush)->Apply([](auto* bench) { for_steps(bench, { 9, 10 }); });
BENCHMARK(derive_tree)->Apply([](auto* bench) { for_steps(bench, { 17, 20 }); });
BENCHMARK(derive_signals)->Apply([](auto* bench) { for_steps(bench, { 60 }); });
BENCHMARK(signal_through_a_row)->Apply([](auto* bench) { for_steps(bench, { 100, 1000 }); });
BENCHMARK(compile_tree);
BENCHMARK(interpret_tree)->Apply([](auto* bench) { for_steps(bench, { 17, 20 }); });

} // namespace
} // namespace tractus
