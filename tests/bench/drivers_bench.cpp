#include "drivers/log.h"
#include "drivers/log_writer.h"
#include "drivers/pen_decoder.h"
#include "tests/bench/report.h"
#include "tests/drivers/devices.h"

#include <sstream>
#include <string>
#include <vector>

namespace tractus {
namespace {

constexpr std::size_t kReports = 1'000'000;
constexpr std::size_t kReportBytes = 10;

// A pen that goes round and round for an hour and a half, touching half of the time.
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
        LogWriter writer(out, { .devices = { simple_pen() } });
        for (std::size_t i = 0; i < kReports; ++i)
            writer.write_report(0, timestamp_ns(static_cast<std::int64_t>(i) * 5'000'000),
                                std::span(reports()).subspan(i * kReportBytes, kReportBytes));
        return out.str();
    }();
    return text;
}

void decode_pen_reports(benchmark::State& state)
{
    auto decoder = *make_pen_decoder(simple_pen());
    for (auto _ : state)
        for (std::size_t i = 0; i < kReports; ++i) {
            auto sample
                = decoder->decode(timestamp_ns(static_cast<std::int64_t>(i)),
                                  std::span(reports()).subspan(i * kReportBytes, kReportBytes));
            benchmark::DoNotOptimize(sample);
        }
    report(state,
           { .items = kReports,
             .item = "reports",
             .bytes = kReports * (kReportBytes + sizeof(PenSample)) });
}
BENCHMARK(decode_pen_reports);

void read_log(benchmark::State& state)
{
    for (auto _ : state) {
        auto log = parse_log(log_text(), "bench");
        benchmark::DoNotOptimize(log);
    }
    auto const bytes = log_text().size() + kReports * (kReportBytes + sizeof(LogRecord));
    report(state, { .items = kReports, .item = "reports", .bytes = static_cast<double>(bytes) });
}
BENCHMARK(read_log);

void write_log(benchmark::State& state)
{
    for (auto _ : state) {
        std::ostringstream out;
        LogWriter writer(out, { .devices = { simple_pen() } });
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
