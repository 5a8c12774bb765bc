#include "drivers/logs/log.h"
#include "drivers/logs/log_writer.h"
#include "drivers/pens/family_decoder.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/check.h"
#include "engine/base/file.h"
#include "tests/bench/report.h"
#include "tests/drivers/devices.h"

#include <filesystem>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus {
namespace {

constexpr std::size_t kReports = 1'000'000;
constexpr std::size_t kReportBytes = 10;

// Returns the reports of a pen that draws circles for an hour and a half, and touches during half
// of this time.
std::vector<std::byte> const& reports()
{
    static auto const all = [] {
        std::vector<std::byte> bytes;
        bytes.reserve(kReports * kReportBytes);
        for (std::size_t i = 0; i < kReports; ++i) {
            auto const x = static_cast<unsigned>(i * 7 % 20'001);
            auto const y = static_cast<unsigned>(i * 5 % 10'001);
            auto const pressure = static_cast<unsigned>(i % 2048);
            for (unsigned const byte :
                 { 2u, i % 2'000 < 1'000 ? 0x21u : 0x20u, x & 255, x >> 8, y & 255, y >> 8,
                   pressure & 255, pressure >> 8, 30u, 226u })
                bytes.push_back(static_cast<std::byte>(byte));
        }
        return bytes;
    }();
    return all;
}

std::string const& log_text()
{
    static auto const text = [] {
        std::ostringstream out;
        drivers::LogWriter writer(out, { .devices = { drivers::simple_pen() } });
        for (std::size_t i = 0; i < kReports; ++i)
            writer.write_report(0, timestamp_ns(static_cast<std::int64_t>(i) * 5'000'000),
                                std::span(reports()).subspan(i * kReportBytes, kReportBytes));
        return out.str();
    }();
    return text;
}

void decode_pen_reports(benchmark::State& state)
{
    auto decoder = *drivers::make_pen_decoder(drivers::simple_pen());
    std::vector<drivers::PenSample> samples;
    for (auto _ : state)
        for (std::size_t i = 0; i < kReports; ++i) {
            samples.clear();
            (void)decoder->decode(timestamp_ns(static_cast<std::int64_t>(i)),
                                  std::span(reports()).subspan(i * kReportBytes, kReportBytes),
                                  samples);
            benchmark::DoNotOptimize(samples.data());
        }
    report(state,
           { .items = kReports,
             .item = "reports",
             .bytes = kReports * (kReportBytes + sizeof(drivers::PenSample)) });
}
BENCHMARK(decode_pen_reports);

// Decodes reports in a maker's own format, of a pen that touches. Its x coordinate is at byte `x`,
// low byte first.
void decode_family_reports(benchmark::State& state, char const* family, char const* text,
                           std::size_t x)
{
    auto const decoder = drivers::make_family_decoder(*drivers::find_pen_family(family),
                                                      { .size_mm = { 254, 158.75 },
                                                        .x_maximum = 65'535,
                                                        .y_maximum = 65'535,
                                                        .pressure_maximum = 8191 });
    auto const report = drivers::bytes(text);
    std::vector<std::byte> all;
    all.reserve(kReports * report.size());
    for (std::size_t i = 0; i < kReports; ++i) {
        all.insert(all.end(), report.begin(), report.end());
        auto const place = all.end() - static_cast<std::ptrdiff_t>(report.size() - x);
        place[0] = static_cast<std::byte>(i & 255);
        place[1] = static_cast<std::byte>((i >> 8) & 255);
    }
    std::vector<drivers::PenSample> samples;
    for (auto _ : state)
        for (std::size_t i = 0; i < kReports; ++i) {
            samples.clear();
            (void)decoder->decode(
                timestamp_ns(static_cast<std::int64_t>(i)),
                std::span<std::byte const>(all).subspan(i * report.size(), report.size()), samples);
            benchmark::DoNotOptimize(samples.data());
        }
    tractus::report(
        state,
        { .items = kReports,
          .item = "reports",
          .bytes = static_cast<double>(kReports * (report.size() + sizeof(drivers::PenSample))) });
}
BENCHMARK_CAPTURE(decode_family_reports, graphire, "wacom-graphire", "02 91 00 00 c4 09 ff 00", 2);
BENCHMARK_CAPTURE(decode_family_reports, intuos, "wacom-intuos", "02 f1 00 00 c4 09 ff 03 05", 2);
BENCHMARK_CAPTURE(decode_family_reports, intuos_pro, "wacom-intuos-pro",
                  "02 e1 00 00 04 e2 40 eb 64 02", 2);
BENCHMARK_CAPTURE(decode_family_reports, intuos_v2, "wacom-intuos-v2",
                  "10 61 00 00 00 c4 09 00 ff 1f 1e e2 00", 2);
BENCHMARK_CAPTURE(decode_family_reports, intuos_v3, "wacom-intuos-v3",
                  "1e 01 c1 00 00 00 c4 09 00 ff 1f 1e 00 e2 ff", 3);
BENCHMARK_CAPTURE(decode_family_reports, uclogic_v2, "uclogic-v2-tilt",
                  "08 81 00 00 c4 09 ff 03 00 00 1e e2", 2);
BENCHMARK_CAPTURE(decode_family_reports, xp_pen, "xp-pen", "07 a1 00 00 c4 09 ff 03 1e e2", 2);
BENCHMARK_CAPTURE(decode_family_reports, veikk, "veikk-tilt",
                  "09 41 a1 00 00 00 c4 09 00 ff 03 1e e2", 3);

void parse_log_text(benchmark::State& state)
{
    for (auto _ : state) {
        auto log = drivers::parse_log(log_text(), "bench");
        benchmark::DoNotOptimize(log);
    }
    auto const bytes = log_text().size() + kReports * (kReportBytes + sizeof(drivers::LogRecord));
    report(state, { .items = kReports, .item = "reports", .bytes = static_cast<double>(bytes) });
}
BENCHMARK(parse_log_text);

void read_log_file(benchmark::State& state)
{
    auto const path = std::filesystem::temp_directory_path()
        / ("tractus_bench_" + std::to_string(::getpid()) + ".tractus-log");
    CHECK(write_file(path, log_text()));
    for (auto _ : state) {
        auto log = drivers::read_log(path);
        benchmark::DoNotOptimize(log);
    }
    std::filesystem::remove(path);
    auto const bytes
        = 2 * log_text().size() + kReports * (kReportBytes + sizeof(drivers::LogRecord));
    report(state, { .items = kReports, .item = "reports", .bytes = static_cast<double>(bytes) });
}
BENCHMARK(read_log_file);

void write_log(benchmark::State& state)
{
    for (auto _ : state) {
        std::ostringstream out;
        drivers::LogWriter writer(out, { .devices = { drivers::simple_pen() } });
        for (std::size_t i = 0; i < kReports; ++i)
            writer.write_report(0, timestamp_ns(static_cast<std::int64_t>(i) * 5'000'000),
                                std::span(reports()).subspan(i * kReportBytes, kReportBytes));
        benchmark::DoNotOptimize(out);
    }
    report(state,
           { .items = kReports,
             .item = "reports",
             .bytes = static_cast<double>(log_text().size() + reports().size()) });
}
BENCHMARK(write_log);

} // namespace
} // namespace tractus
