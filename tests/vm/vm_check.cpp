// What the scenarios in tests/vm let judge. Prints what it finds, figures as "figure: NAME = VALUE
// UNIT", and exits with 1 if it is not as it should be.
#include "drivers/log.h"
#include "engine/base/result.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/core.h>
#include <functional>
#include <string>
#include <vector>

namespace tractus {

namespace {

using Check = std::function<Result<void>()>;

Result<void> print_figure(std::string const& name, double value, std::string const& unit)
{
    fmt::print("figure: {} = {:.3f} {}\n", name, value, unit);
    return {};
}

std::vector<LogRecord> records_of(Log const& log, std::size_t device)
{
    std::vector<LogRecord> records;
    std::copy_if(log.records.begin(), log.records.end(), std::back_inserter(records),
                 [&](LogRecord const& record) { return record.device == device; });
    return records;
}

// The device of `log` with this report descriptor.
Result<std::size_t> find_device(Log const& log, DeviceInfo const& wanted)
{
    for (std::size_t i = 0; i < log.devices.size(); ++i)
        if (log.devices[i].report_descriptor == wanted.report_descriptor)
            return i;
    return fail(
        Fault::Device,
        fmt::format("{} has no device with the report descriptor of {}", log.name, wanted.name));
}

Result<void> compare_device(Log const& sent, std::size_t sent_device, Log const& got)
{
    auto const& info = sent.devices[sent_device];
    auto const got_device = TRY(find_device(got, info));
    auto const expected = records_of(sent, sent_device);
    auto const actual = records_of(got, got_device);
    for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i) {
        auto const a = sent.report(expected[i]);
        auto const b = got.report(actual[i]);
        if (!std::equal(a.begin(), a.end(), b.begin(), b.end()))
            return fail(Fault::Device,
                        fmt::format("{}: report {} is not what was sent, at {:.6f} s", info.name, i,
                                    to_seconds(actual[i].time)));
    }
    if (expected.size() != actual.size())
        return fail(Fault::Device,
                    fmt::format("{}: {} reports came of {} that were sent", info.name,
                                actual.size(), expected.size()));
    fmt::print("{}: all {} reports came as they were sent\n", info.name, actual.size());
    return {};
}

Result<void> compare_reports(std::string const& sent_name, std::string const& got_name)
{
    auto const sent = TRY(read_log(sent_name));
    auto const got = TRY(read_log(got_name));
    for (std::size_t i = 0; i < sent.devices.size(); ++i)
        TRY(compare_device(sent, i, got));
    return {};
}

// Between the reports of the log's first device, gaps of more than `pause_ms` left out: there the
// pen was away.
Result<void> measure_gaps(std::string const& name, double pause_ms)
{
    auto const log = TRY(read_log(name));
    auto const records = records_of(log, 0);
    std::vector<double> gaps_ms;
    for (std::size_t i = 1; i < records.size(); ++i) {
        double const gap_ms = 1000 * to_seconds(records[i].time - records[i - 1].time);
        if (gap_ms <= pause_ms)
            gaps_ms.push_back(gap_ms);
    }
    if (gaps_ms.size() < 2)
        return fail(Fault::Device, fmt::format("{}: there are no gaps to measure", name));
    double mean_ms = 0;
    for (double const gap_ms : gaps_ms)
        mean_ms += gap_ms / static_cast<double>(gaps_ms.size());
    double variance = 0;
    for (double const gap_ms : gaps_ms)
        variance += std::pow(gap_ms - mean_ms, 2) / static_cast<double>(gaps_ms.size() - 1);
    TRY(print_figure("reports", static_cast<double>(records.size()), ""));
    TRY(print_figure("gap mean", mean_ms, "ms"));
    TRY(print_figure("gap sd", std::sqrt(variance), "ms"));
    return print_figure("gap max", *std::max_element(gaps_ms.begin(), gaps_ms.end()), "ms");
}

void add_checks(CLI::App& root, Check& check)
{
    auto* const same = root.add_subcommand("same-reports", "Was every report got as it was sent?");
    auto const sent = std::make_shared<std::string>();
    auto const got = std::make_shared<std::string>();
    same->add_option("SENT", *sent)->required();
    same->add_option("GOT", *got)->required();
    same->callback(
        [&check, sent, got] { check = [sent, got] { return compare_reports(*sent, *got); }; });

    auto* const gaps
        = root.add_subcommand("gaps", "How regular do the first device's reports come?");
    auto const pause_ms = std::make_shared<double>(50);
    gaps->add_option("LOG", *got)->required();
    gaps->add_option("--pause-ms", *pause_ms);
    gaps->callback([&check, got, pause_ms] {
        check = [got, pause_ms] { return measure_gaps(*got, *pause_ms); };
    });
}

int run(int argc, char const* const* argv)
{
    CLI::App root("Judges what a scenario did");
    Check check;
    add_checks(root, check);
    root.require_subcommand(1);
    CLI11_PARSE(root, argc, argv);
    auto const result = check();
    if (!result)
        fmt::print("failed: {}\n", result.error().message);
    return result ? 0 : 1;
}

} // namespace

} // namespace tractus

int main(int argc, char** argv)
{
    return tractus::run(argc, argv);
}
