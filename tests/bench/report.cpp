#include "tests/bench/report.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <spawn.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace tractus {

namespace {

// Names in the order of Limit.
constexpr std::array<char const*, 4> kLimitNames { "copy", "fill", "disk", "cp" };
constexpr std::size_t kBlockBytes = 64 << 20;
// Number of runs of which the best counts, since the machine may be busy with other things.
constexpr int kRuns = 12;

void write_once(std::vector<char> const& block)
{
    auto const path = std::filesystem::temp_directory_path()
        / fmt::format("tractus-bench-limit-{}", ::getpid());
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(block.data(), static_cast<std::streamsize>(block.size()));
    out.close();
    std::filesystem::remove(path);
}

double measure_bytes_per_second(Limit limit)
{
    std::vector<char> const from(kBlockBytes, 1);
    std::vector<char> to(limit == Limit::Disk ? 0 : kBlockBytes, 2);
    double best_s = 1e9;
    for (int run = 0; run < kRuns; ++run) {
        auto const start = std::chrono::steady_clock::now();
        switch (limit) {
        case Limit::Copy:
            std::memcpy(to.data(), from.data(), to.size());
            break;
        case Limit::Fill:
            std::memset(to.data(), run, to.size());
            break;
        case Limit::Disk:
            write_once(from);
            break;
        case Limit::Cp: // See copy_bytes_per_second(): this limit depends on the file.
            break;
        }
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        std::chrono::duration<double> const took = std::chrono::steady_clock::now() - start;
        best_s = std::min(best_s, took.count());
    }
    return static_cast<double>(kBlockBytes) / best_s;
}

double copy_bytes_per_second(std::filesystem::path const& file)
{
    auto const copy = file.string() + ".copy";
    double best_s = 1e9;
    for (int run = 0; run < kRuns; ++run) {
        std::filesystem::remove(copy);
        auto const start = std::chrono::steady_clock::now();
        pid_t child = 0;
        char const* const arguments[] = { "cp", file.c_str(), copy.c_str(), nullptr };
        if (::posix_spawnp(&child, "cp", nullptr, nullptr, const_cast<char* const*>(arguments),
                           environ)
            != 0)
            return 0;
        int status = 0;
        if (::waitpid(child, &status, 0) != child || status != 0)
            return 0;
        std::chrono::duration<double> const took = std::chrono::steady_clock::now() - start;
        best_s = std::min(best_s, took.count());
    }
    std::filesystem::remove(copy);
    return static_cast<double>(std::filesystem::file_size(file)) / best_s;
}

double bytes_per_second(Limit limit)
{
    static std::array<double, kLimitNames.size()> measured {};
    auto& result = measured[static_cast<std::size_t>(limit)];
    if (result == 0)
        result = measure_bytes_per_second(limit);
    return result;
}

std::string counter_name(std::string_view limit)
{
    return fmt::format("{}_bytes_per_second", limit);
}

// Returns this process's minor page faults since the last call.
double new_faults()
{
    static long before = 0;
    rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    long const faults = usage.ru_minflt - before;
    before = usage.ru_minflt;
    return static_cast<double>(faults);
}

// Formats a value with about four digits and a prefixed unit, such as "12.35 ns" or "2.31 G
// modules/s".
std::string with_prefix(double value, std::string_view unit)
{
    struct Prefix {
        double factor;
        char const* name;
    };
    constexpr std::array<Prefix, 7> kPrefixes { { { 1e9, "G" },
                                                  { 1e6, "M" },
                                                  { 1e3, "k" },
                                                  { 1, "" },
                                                  { 1e-3, "m" },
                                                  { 1e-6, "µ" },
                                                  { 1e-9, "n" } } };
    auto const* prefix = kPrefixes.begin();
    while (value < prefix->factor && prefix + 1 != kPrefixes.end())
        ++prefix;
    double const scaled = value / prefix->factor;
    bool const is_word = unit.size() > 1 && std::islower(unit[0]) != 0;
    return fmt::format("{:.{}f} {}{}{}", scaled,
                       scaled < 10        ? 2
                           : scaled < 100 ? 1
                                          : 0,
                       prefix->name, is_word && *prefix->name != '\0' ? " " : "", unit);
}

void print_row(std::string_view name, std::string_view figure, std::string_view each,
               std::string_view bytes, std::string_view run, std::string_view faults,
               std::string_view limit, std::string_view share)
{
    auto const split = figure.find(' ');
    fmt::print("{:<36}{:>6} {:<17}{:>9}{:>9}{:>10}{:>9}  {:<15}{:>8}\n", name,
               figure.substr(0, split), split < figure.size() ? figure.substr(split + 1) : "", each,
               bytes, run, faults, limit, share);
    std::fflush(stdout);
}

using Run = benchmark::BenchmarkReporter::Run;

double counter(Run const& run, std::string const& name)
{
    auto const found = run.counters.find(name);
    return found == run.counters.end() ? 0 : found->second.value;
}

std::string limit_of(Run const& run)
{
    for (auto const* name : kLimitNames)
        if (double const limit = counter(run, counter_name(name)); limit > 0)
            return fmt::format("{} {}", name, with_prefix(limit, "B/s"));
    return "";
}

// Returns why a benchmark was aborted; null if it was not. Google Benchmark 1.8 renamed the members
// that say so.
template<typename AnyRun> std::string const* failure_of(AnyRun const& run)
{
    if constexpr (requires { run.skip_message; })
        return run.skipped ? &run.skip_message : nullptr;
    else
        return run.error_occurred ? &run.error_message : nullptr;
}

void print_run(Run const& run)
{
    auto const name = run.run_name.args.empty()
        ? run.run_name.function_name
        : fmt::format("{}/{}", run.run_name.function_name, run.run_name.args);
    if (auto const* failure = failure_of(run)) {
        fmt::print("{:<36}{}\n", name, *failure);
        return;
    }
    double const rate = counter(run, "items_per_second");
    double const bytes = counter(run, "bytes_per_item");
    double const share = counter(run, "of_limit");
    double const run_s = run.real_accumulated_time / static_cast<double>(run.iterations);
    print_row(name, with_prefix(rate, run.report_label + "/s"), with_prefix(1 / rate, "s"),
              bytes > 0 ? with_prefix(bytes, "B") : "", with_prefix(run_s, "s"),
              fmt::format("{:.0f}", counter(run, "faults")), limit_of(run),
              share > 0 ? fmt::format("{:.4f}", share) : "");
}

// Prints one line for each benchmark. It shows the best repetition, since the machine may be busy
// with other things.
class TableReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(Context const&) override { return true; }

    void ReportRuns(std::vector<Run> const& runs) override
    {
        auto const is_measured = [](Run const& run) { return run.run_type == Run::RT_Iteration; };
        auto const time = [](Run const& run) {
            return run.real_accumulated_time / static_cast<double>(run.iterations);
        };
        Run const* best = nullptr;
        for (auto const& run : runs)
            if (is_measured(run) && (!best || time(run) < time(*best)))
                best = &run;
        if (best)
            print_run(*best);
    }
};

} // namespace

void report(benchmark::State& state, Work const& work)
{
    using benchmark::Counter;
    auto const iterations = static_cast<double>(state.iterations());
    state.SetLabel(work.item);
    auto const faults = new_faults();
    state.counters["faults"] = work.faults < 0 ? faults / iterations : work.faults;
    state.counters["items_per_second"] = Counter(work.items * iterations, Counter::kIsRate);
    if (work.bytes <= 0)
        return;
    double const limit
        = work.limit == Limit::Cp ? copy_bytes_per_second(work.file) : bytes_per_second(work.limit);
    auto const* const name = kLimitNames[static_cast<std::size_t>(work.limit)];
    state.counters["bytes_per_item"] = work.bytes / work.items;
    state.counters[counter_name(name)] = limit;
    state.counters["of_limit"] = Counter(work.bytes * iterations / limit, Counter::kIsRate);
}

} // namespace tractus

// With --heading, prints only the table's first line.
int main(int argc, char** argv)
{
    if (argc == 2 && std::string_view(argv[1]) == "--heading") {
        tractus::print_row("benchmark", "figure unit", "each", "bytes", "run", "faults", "limit",
                           "of limit");
        return 0;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    tractus::TableReporter table;
    benchmark::RunSpecifiedBenchmarks(&table);
    benchmark::Shutdown();
    return 0;
}
