#include "drivers/links/hid_source.h"
#include "drivers/links/threaded_source.h"
#include "drivers/reports/report_descriptor.h"
#include "tests/vm/checks.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <iterator>
#include <thread>

namespace tractus {

namespace {

// Returns the reports of a device, without the empty ones that mark a disconnection.
std::vector<drivers::LogRecord> records_of(drivers::Log const& log, std::size_t device)
{
    std::vector<drivers::LogRecord> records;
    std::copy_if(log.records.begin(), log.records.end(), std::back_inserter(records),
                 [&](drivers::LogRecord const& record) {
                     return record.device == device && record.size > 0;
                 });
    return records;
}

// Returns the device of `log` with the report descriptor of `wanted`.
Result<std::size_t> find_device(drivers::Log const& log, drivers::DeviceInfo const& wanted)
{
    for (std::size_t i = 0; i < log.devices.size(); ++i)
        if (log.devices[i].report_descriptor == wanted.report_descriptor)
            return i;
    return fail(
        Fault::Device,
        fmt::format("{} has no device with the report descriptor of {}", log.name, wanted.name));
}

// Returns the reports that the kernel passes on to hidraw: those that the descriptor declares, if
// they have at least the declared length.
std::vector<drivers::LogRecord> delivered(drivers::Log const& log, std::size_t device)
{
    auto records = records_of(log, device);
    auto const descriptor = drivers::parse_report_descriptor(log.devices[device].report_descriptor);
    if (!descriptor)
        return records;
    bool const has_ids = !descriptor->report_size(drivers::HidReportKind::Input, 0);
    std::erase_if(records, [&](drivers::LogRecord const& record) {
        auto const id
            = has_ids ? std::to_integer<std::uint8_t>(log.report(record)[0]) : std::uint8_t { 0 };
        auto const size = descriptor->report_size(drivers::HidReportKind::Input, id);
        return size == 0 || record.size < size;
    });
    return records;
}

bool is_same(std::span<std::byte const> a, std::span<std::byte const> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// Removes records from the beginning while more than `count` are left and the first is repeated.
void forget_repetitions(drivers::Log const& log, std::vector<drivers::LogRecord>& records,
                        std::size_t count)
{
    while (records.size() > count && is_same(log.report(records[0]), log.report(records[1])))
        records.erase(records.begin());
}

Result<void> compare_device(drivers::Log const& sent, std::size_t sent_device,
                            drivers::Log const& got, FirstReport first)
{
    auto const& info = sent.devices[sent_device];
    auto const got_device = TRY(find_device(got, info));
    auto const expected = delivered(sent, sent_device);
    auto actual = records_of(got, got_device);
    if (first == FirstReport::Repeated)
        forget_repetitions(got, actual, std::max<std::size_t>(expected.size(), 1));
    for (std::size_t i = 0; i < std::min(expected.size(), actual.size()); ++i)
        if (!is_same(sent.report(expected[i]), got.report(actual[i])))
            return fail(Fault::Device,
                        fmt::format("{}: report {} is not what was sent, at {:.6f} s", info.name, i,
                                    to_seconds(actual[i].time)));
    if (expected.size() != actual.size())
        return fail(Fault::Device,
                    fmt::format("{}: {} reports came of {} that were sent", info.name,
                                actual.size(), expected.size()));
    auto const refused = records_of(sent, sent_device).size() - expected.size();
    fmt::print("{}: all {} reports came as they were sent{}\n", info.name, actual.size(),
               refused ? fmt::format(", but for {} that do not fit the descriptor", refused) : "");
    return {};
}

// Waits until the node exists, and returns its description.
Result<drivers::DeviceInfo> find_node(std::string const& node)
{
    for (auto const& info : drivers::enumerate_hid())
        if (info.location == node)
            return info;
    return fail(Fault::Device, fmt::format("there is no {}", node));
}

} // namespace

void print_figure(std::string const& name, double value, std::string const& unit)
{
    fmt::print("figure: {} = {:.3f} {}\n", name, value, unit);
}

Result<void> compare_reports(std::string const& sent_name, std::string const& got_name,
                             std::vector<std::size_t> sent_devices, FirstReport first)
{
    auto const sent = TRY(drivers::read_log(sent_name));
    auto const got = TRY(drivers::read_log(got_name));
    if (sent_devices.empty())
        for (std::size_t i = 0; i < sent.devices.size(); ++i)
            sent_devices.push_back(i);
    for (auto const device : sent_devices)
        TRY(compare_device(sent, device, got, first));
    return {};
}

Result<void> measure_gaps(std::string const& log_name, std::size_t device, double pause_ms)
{
    auto const log = TRY(drivers::read_log(log_name));
    auto const records = records_of(log, device);
    std::vector<double> gaps_ms;
    for (std::size_t i = 1; i < records.size(); ++i) {
        double const gap_ms = 1000 * to_seconds(records[i].time - records[i - 1].time);
        if (gap_ms <= pause_ms)
            gaps_ms.push_back(gap_ms);
    }
    if (gaps_ms.size() < 2)
        return fail(Fault::Device, fmt::format("{}: there are no gaps to measure", log_name));
    auto const count = static_cast<double>(gaps_ms.size());
    double mean_ms = 0;
    for (double const gap_ms : gaps_ms)
        mean_ms += gap_ms / count;
    double variance = 0;
    for (double const gap_ms : gaps_ms)
        variance += std::pow(gap_ms - mean_ms, 2) / (count - 1);
    print_figure("gap mean", mean_ms, "ms");
    print_figure("gap sd", std::sqrt(variance), "ms");
    std::sort(gaps_ms.begin(), gaps_ms.end());
    print_figure("gap p99", gaps_ms[gaps_ms.size() * 99 / 100], "ms");
    print_figure("gap max", gaps_ms.back(), "ms");
    return {};
}

Result<void> read_late(std::string const& node, std::string const& sent_name, double seconds)
{
    auto const sent = TRY(drivers::read_log(sent_name));
    auto const info = TRY(find_node(node));
    auto opened = TRY(drivers::open_hid(info));
    auto const source = TRY(drivers::ThreadedSource::start(std::move(opened)));
    std::this_thread::sleep_for(from_seconds(seconds));
    auto const expected = records_of(sent, 0);
    std::size_t count = 0;
    // Reading ends with an error when the device is unplugged.
    for (auto report = source->read(std::chrono::seconds(1)); report && *report;
         report = source->read(std::chrono::seconds(1)), ++count)
        if (count >= expected.size() || !is_same(sent.report(expected[count]), (*report)->bytes()))
            return fail(Fault::Device, fmt::format("report {} is not what was sent", count));
    if (count != expected.size())
        return fail(Fault::Device,
                    fmt::format("{} reports came of {} that were sent", count, expected.size()));
    fmt::print("all {} reports were there {} s later\n", count, seconds);
    return {};
}

} // namespace tractus
