#include "tests/bench/report.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <map>
#include <vector>

namespace tractus {

namespace {

void write_once(std::vector<char> const& block)
{
    auto const path = std::filesystem::temp_directory_path() / "tractus-bench-limit";
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    out.write(block.data(), static_cast<std::streamsize>(block.size()));
    out.close();
    std::filesystem::remove(path);
}

double measure(Limit limit, std::size_t bytes)
{
    std::vector<char> from(bytes, 1);
    std::vector<char> to(bytes, 2);
    double best_s = 1e9;
    for (int run = 0; run < 7; ++run) {
        auto const start = std::chrono::steady_clock::now();
        switch (limit) {
        case Limit::Copy:
            std::memcpy(to.data(), from.data(), bytes);
            break;
        case Limit::Fill:
            std::memset(to.data(), run, bytes);
            break;
        case Limit::Disk:
            write_once(from);
            break;
        }
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        best_s = std::min(
            best_s,
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return static_cast<double>(bytes) / best_s;
}

// One line per benchmark: name, figure, unit, share of the limit.
class TableReporter : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(Context const&) override { return true; }

    void ReportRuns(std::vector<Run> const& runs) override
    {
        for (auto const& run : runs) {
            if (run.error_occurred) {
                fmt::print("{:<44} {}\n", run.benchmark_name(), run.error_message);
                continue;
            }
            auto const rate = run.counters.find("items_per_s");
            auto const share = run.counters.find("of_limit");
            if (rate == run.counters.end() || share == run.counters.end()) {
                fmt::print("{:<44} {:>10.3f} {:<22}\n", run.benchmark_name(),
                           run.GetAdjustedRealTime(), benchmark::GetTimeUnitString(run.time_unit));
                continue;
            }
            fmt::print("{:<44} {:>10.3f} {:<22} {:>8.3f}\n", run.benchmark_name(),
                       rate->second.value / 1e6, "M " + run.report_label + "/s",
                       share->second.value);
        }
        std::fflush(stdout);
    }
};

} // namespace

double limit_bytes_per_second(Limit limit, std::size_t bytes)
{
    static std::map<std::pair<Limit, std::size_t>, double> measured;
    auto const [found, is_new] = measured.try_emplace({ limit, bytes }, 0);
    if (is_new)
        found->second = measure(limit, bytes);
    return found->second;
}

void report(benchmark::State& state, Work const& work)
{
    using benchmark::Counter;
    auto const iterations = static_cast<double>(state.iterations());
    double const limit = limit_bytes_per_second(work.limit, static_cast<std::size_t>(work.bytes));
    state.SetLabel(work.item);
    state.counters["items_per_s"] = Counter(work.items * iterations, Counter::kIsRate);
    state.counters["of_limit"] = Counter(work.bytes * iterations / limit, Counter::kIsRate);
}

} // namespace tractus

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    tractus::TableReporter table;
    benchmark::RunSpecifiedBenchmarks(&table);
    benchmark::Shutdown();
    return 0;
}
