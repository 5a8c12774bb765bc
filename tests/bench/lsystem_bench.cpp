#include "engine/lsystem/derive.h"
#include "engine/lsystem/turtle.h"

#include <benchmark/benchmark.h>
#include <cstring>
#include <string>
#include <vector>

namespace tractus {
namespace {

// The workloads that published measurements of L-system engines use.

// ABoP figure 1.24a: 2.5 * 5^n - 1.5 modules after n steps.
constexpr char const* kBush = "Lsystem: 1\nderivation length: 10\nAxiom: F\nF --> F[+F]F[-F]F\nendlsystem\n";

// ABoP figure 2.6, a monopodial tree, each rule split into two of which chance takes one:
// 7 * 2^n - 6 modules and 2^n - 1 segments.
constexpr char const* kTree = R"(#define r1 0.9
#define r2 0.6
#define wr 0.707
Lsystem: 1
seed: 1
derivation length: 17
Axiom: A(1,10)
A(l,w) --> !(w)F(l)[&(45)B(l*r2,w*wr)]/(137.5)A(l*r1,w*wr) : 0.5
A(l,w) --> !(w)F(l)[&(50)B(l*r2,w*wr)]/(137.5)A(l*r1,w*wr) : 0.5
B(l,w) --> !(w)F(l)[-(45)@vC(l*r2,w*wr)]C(l*r1,w*wr) : 0.5
B(l,w) --> !(w)F(l)[-(50)@vC(l*r2,w*wr)]C(l*r1,w*wr) : 0.5
C(l,w) --> !(w)F(l)[+(45)@vB(l*r2,w*wr)]B(l*r1,w*wr) : 0.5
C(l,w) --> !(w)F(l)[+(50)@vB(l*r2,w*wr)]B(l*r1,w*wr) : 0.5
endlsystem
)";

// ABoP figure 1.31a: contexts over brackets.
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

Model compiled(std::string const& rules)
{
    ModelSource source;
    source.text = rules;
    return compile_model(source).value();
}

// Seconds that memcpy takes for so many bytes, source and target as large as they are here: what the
// memory allows.
double memcpy_seconds(std::size_t bytes)
{
    std::vector<char> const from(bytes, 1);
    std::vector<char> to(bytes);
    constexpr int kRounds = 5;
    auto const begin = std::chrono::steady_clock::now();
    for (int i = 0; i < kRounds; ++i) {
        std::memcpy(to.data(), from.data(), bytes);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / kRounds;
}

void derive_model(benchmark::State& state, std::string const& rules)
{
    auto const model = compiled(rules);
    DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    std::size_t modules = 0;
    std::size_t bytes = 0;
    for (auto _ : state) {
        auto const string = derive(model, options).value();
        modules = string.size();
        bytes = string.kinds.size() + string.parameters.size() * sizeof(float);
        benchmark::DoNotOptimize(string.kinds.data());
    }
    using benchmark::Counter;
    state.counters["modules"] = static_cast<double>(modules);
    state.counters["modules_per_s"] = Counter(static_cast<double>(modules), Counter::kIsIterationInvariantRate);
    state.counters["bytes_per_module"] = static_cast<double>(bytes) / static_cast<double>(modules);
    // Time divided by that of copying the last string once.
    state.counters["times_memcpy"] = Counter(1 / memcpy_seconds(bytes),
                                             Counter::Flags(Counter::kIsIterationInvariantRate | Counter::kInvert));
    state.counters["times_memcpy"].value = memcpy_seconds(bytes);
}

void BM_DeriveBush(benchmark::State& state) { derive_model(state, kBush); }
void BM_DeriveTree(benchmark::State& state) { derive_model(state, kTree); }
void BM_DeriveSignals(benchmark::State& state) { derive_model(state, kSignals); }

// Module-steps per second: the row is rewritten in every step.
void BM_SignalThroughARow(benchmark::State& state)
{
    auto const model = compiled(row_of_signals());
    DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(derive(model, options).value().kinds.data());
    state.counters["module_steps_per_s"] = benchmark::Counter(20'001.0 * static_cast<double>(state.range(0)),
                                                              benchmark::Counter::kIsIterationInvariantRate);
}

void BM_CompileModel(benchmark::State& state)
{
    ModelSource source;
    source.text = kTree;
    for (auto _ : state)
        benchmark::DoNotOptimize(compile_model(source).value());
}

void BM_InterpretTree(benchmark::State& state)
{
    auto const model = compiled(kTree);
    DeriveOptions options;
    options.steps = static_cast<int>(state.range(0));
    auto const string = derive(model, options).value();
    std::size_t segments = 0;
    for (auto _ : state) {
        auto const plant = interpret(model, string).value();
        segments = plant.segment_count();
        benchmark::DoNotOptimize(plant.axes.data());
    }
    state.counters["segments"] = static_cast<double>(segments);
    state.counters["segments_per_s"] = benchmark::Counter(static_cast<double>(segments),
                                                          benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(BM_DeriveBush)->Arg(9)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DeriveTree)->Arg(17)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_DeriveSignals)->Arg(30)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SignalThroughARow)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CompileModel)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_InterpretTree)->Arg(17)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace tractus
