#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
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

// Starts the program and returns its process id; 0 if that failed.
pid_t start_program(std::vector<std::string> arguments)
{
    arguments.insert(arguments.begin(), TRACTUS_PROGRAM);
    std::vector<char*> pointers;
    for (auto& argument : arguments)
        pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    pid_t child = 0;
    bool const has_started
        = ::posix_spawn(&child, TRACTUS_PROGRAM, nullptr, nullptr, pointers.data(), environ) == 0;
    return has_started ? child : 0;
}

// Returns a running process's minor page faults so far; negative if it has ended.
double faults_of(pid_t process)
{
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string text(std::istreambuf_iterator<char>(file), {});
    auto const name_end = text.rfind(')');
    if (name_end == std::string::npos)
        return -1;
    std::istringstream fields(
        text.substr(name_end + 1)); // From the third field on; minflt is the 10th.
    std::string field;
    for (int i = 3; i <= 10; ++i)
        fields >> field;
    return std::stod(field);
}

// Returns a recording in which the demo's hand draws all the time that whole_window() measures. The
// parts of a recording may begin again at time 0.
std::string long_recording()
{
    constexpr int kParts = 4; // The demo takes 13 s.
    auto const path = folder() / "hand.tractus-log";
    std::ofstream out(path);
    for (int i = 0; i < kParts; ++i)
        out << std::ifstream(TRACTUS_DEMO).rdbuf();
    return path.string();
}

// Measures the pages that the window touches for the first time while a recorded hand draws in it,
// after a few seconds in which the program has taken what it needs. The window needs a display:
// tests/bench/run gives it one that is not seen.
void whole_window(benchmark::State& state)
{
    constexpr auto kWarmUp = std::chrono::seconds(8); // Three of them until the window is open.
    constexpr auto kMeasured = std::chrono::seconds(20);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread runs.
    if (std::getenv("DISPLAY") == nullptr)
        return state.SkipWithError("there is no display");
    double faults = -1;
    for (auto _ : state) {
        auto const window
            = start_program({ "window", "--log", long_recording(), "--plant", "broadleaf",
                              "--session", (folder() / "a.tractus").string() });
        if (window == 0)
            return state.SkipWithError("the program failed");
        std::this_thread::sleep_for(kWarmUp);
        auto const before = faults_of(window);
        std::this_thread::sleep_for(kMeasured);
        auto const after = faults_of(window);
        faults = before < 0 || after < 0 ? -1 : after - before;
        ::kill(window, SIGTERM);
        ::waitpid(window, nullptr, 0);
        state.SetIterationTime(std::chrono::duration<double>(kMeasured).count());
    }
    if (faults < 0)
        return state.SkipWithError("the window has not stayed open");
    report(state, { .items = faults, .item = "faults", .faults = faults });
}

void once(benchmark::internal::Benchmark* bench, std::int64_t steps)
{
    bench->Arg(steps)->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(whole_start)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(whole_window)->Iterations(1)->UseManualTime();
BENCHMARK(whole_bush)->Apply([](auto* bench) { once(bench, 10); });
BENCHMARK(whole_tree)->Apply([](auto* bench) { once(bench, 20); });
BENCHMARK(whole_signals)->Apply([](auto* bench) { once(bench, 60); });
BENCHMARK(whole_row)->Apply([](auto* bench) { once(bench, 1000); });
BENCHMARK(whole_grow)->Apply([](auto* bench) { once(bench, 19); });
BENCHMARK(whole_grow_compressed)->Apply([](auto* bench) { once(bench, 19); });

} // namespace
} // namespace tractus
