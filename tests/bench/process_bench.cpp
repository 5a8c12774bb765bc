#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"

#include <fcntl.h>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <spawn.h>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

// Measures whole processes, from start to end, with the models of lsystem_bench.cpp.

namespace tractus {
namespace {

namespace fs = std::filesystem;

constexpr char const* kBush
    = "Lsystem: 1\nderivation length: 10\nAxiom: F\nF --> F[+F]F[-F]F\nendlsystem\n";

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

// A temporary folder that exists while the program runs.
class Folder {
public:
    Folder() { fs::create_directories(path_); }
    ~Folder() { fs::remove_all(path_); }
    fs::path operator/(std::string const& name) const { return path_ / name; }

private:
    fs::path path_ = fs::temp_directory_path() / fmt::format("tractus-bench-{}", ::getpid());
};

Folder const& folder()
{
    static Folder const made;
    return made;
}

std::string model(std::string const& name, std::string const& rules)
{
    auto const path = folder() / name;
    std::ofstream(path) << rules;
    return path.string();
}

// Runs the program and returns its minor page faults; negative if it failed.
double run_program(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), TRACTUS_PROGRAM);
    std::vector<char*> pointers;
    for (auto& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    int const failure
        = ::posix_spawn(&child, TRACTUS_PROGRAM, &actions, nullptr, pointers.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    rusage usage {};
    if (failure != 0 || ::wait4(child, &status, 0, &usage) != child || status != 0)
        return -1;
    return static_cast<double>(usage.ru_minflt);
}

// Measures one run of the program. `work.bytes` is the size of the run's result.
void measure(benchmark::State& state, std::vector<std::string> const& arguments, Work work)
{
    for (auto _ : state)
        work.faults = run_program(arguments);
    if (work.faults < 0)
        return state.SkipWithError("the program failed");
    report(state, work);
}

void derive_and_count(benchmark::State& state, std::string const& path, double modules)
{
    measure(state, { "derive", path, "-n", std::to_string(state.range(0)), "--count" },
            { .items = modules, .item = "modules" });
}

void whole_start(benchmark::State& state)
{
    measure(state, { "--version" }, { .items = 1, .item = "starts" });
}
void whole_bush(benchmark::State& state)
{
    double modules = 2.5;
    for (auto i = state.range(0); i > 0; --i)
        modules *= 5;
    derive_and_count(state, model("bush.l", kBush), modules - 1.5);
}
void whole_tree(benchmark::State& state)
{
    derive_and_count(state, model("tree.l", kMonopodialTree),
                     7 * static_cast<double>(std::int64_t { 1 } << state.range(0)) - 6);
}
void whole_signals(benchmark::State& state)
{
    // The third argument is the number of modules after 60 steps.
    derive_and_count(state, model("signals.l", kSignals), 9'239'061);
}
void whole_row(benchmark::State& state)
{
    derive_and_count(state,
                     model("row.l",
                           "Lsystem: 1\nderivation length: 100\nAxiom: B" + std::string(20'000, 'A')
                               + "\nB < A --> B\nB --> A\nendlsystem\n"),
                     20'001.0 * static_cast<double>(state.range(0)));
}

// Measures a process that starts, derives, draws, meshes and writes a model.
void grow_into_file(benchmark::State& state, std::vector<std::string> const& options)
{
    auto const path = model("grown.l", kMonopodialTree);
    auto const out = (folder() / "tree.glb").string();
    std::vector<std::string> arguments { "grow", path, "-n", std::to_string(state.range(0)),
                                         "-o",   out };
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (run_program(arguments) < 0)
        return state.SkipWithError("the program failed");
    measure(state, arguments,
            { .items = static_cast<double>((std::int64_t { 1 } << state.range(0)) - 1),
              .item = "segments",
              .bytes = static_cast<double>(fs::file_size(out)),
              .limit = Limit::Disk });
}

void whole_grow(benchmark::State& state)
{
    grow_into_file(state, {});
}
void whole_grow_compressed(benchmark::State& state)
{
    grow_into_file(state, { "--compressed" });
}

void once(benchmark::internal::Benchmark* bench, std::int64_t steps)
{
    bench->Arg(steps)->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(whole_start)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(whole_bush)->Apply([](auto* bench) { once(bench, 10); });
BENCHMARK(whole_tree)->Apply([](auto* bench) { once(bench, 20); });
BENCHMARK(whole_signals)->Apply([](auto* bench) { once(bench, 60); });
BENCHMARK(whole_row)->Apply([](auto* bench) { once(bench, 1000); });
BENCHMARK(whole_grow)->Apply([](auto* bench) { once(bench, 19); });
BENCHMARK(whole_grow_compressed)->Apply([](auto* bench) { once(bench, 19); });

} // namespace
} // namespace tractus
