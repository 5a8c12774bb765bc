#include "calib/fuser.h"
#include "calib/height_monitor.h"
#include "sim/simulated_rig.h"
#include "tests/bench/report.h"

#include <cmath>
#include <numbers>

namespace tractus {
namespace {

using namespace std::chrono_literals;

// Pen samples of a minute at 200 Hz and height samples of a minute at 500 Hz, in order of arrival.
struct Samples {
    std::vector<drivers::PenSample> pens;
    std::vector<drivers::HeightSample> heights;
};

Samples one_minute()
{
    Samples samples;
    for (auto time = Timestamp {}; time < Timestamp(60s); time += 5ms) {
        drivers::PenSample pen;
        pen.time = time;
        pen.position_mm = { 100 + 50 * std::sin(to_seconds(time)), 80 };
        pen.pressure = 0.5;
        pen.in_range = pen.touching = true;
        samples.pens.push_back(pen);
    }
    for (auto time = Timestamp {}; time < Timestamp(60s); time += 2ms) {
        double const counts = 2000 + 1500 * std::sin(to_seconds(time));
        samples.heights.push_back(
            { .time = time, .counts = static_cast<std::int32_t>(counts), .full_scale = 4095 });
    }
    return samples;
}

void fuse_pen_and_height(benchmark::State& state)
{
    auto const samples = one_minute();
    calib::Rig const rig = sim::true_rig({});
    for (auto _ : state) {
        calib::Fuser fuser(rig);
        auto height = samples.heights.begin();
        for (auto const& pen : samples.pens) {
            for (; height != samples.heights.end() && height->time <= pen.time; ++height)
                fuser.push(*height);
            benchmark::DoNotOptimize(fuser.push(pen));
        }
        fuser.flush();
        benchmark::DoNotOptimize(fuser.take_settled());
    }
    auto const pens = static_cast<double>(samples.pens.size());
    auto const heights = static_cast<double>(samples.heights.size());
    report(state,
           { .items = pens,
             .item = "pen samples",
             .bytes = pens * (sizeof(drivers::PenSample) + sizeof(TipSample))
                 + heights * sizeof(drivers::HeightSample) });
}
BENCHMARK(fuse_pen_and_height);

// A trembling hand moves the surface: the pairs of corners that slips are told from.
void watch_a_minute_of_heights(benchmark::State& state)
{
    constexpr double kTremor_hz = 9;
    calib::Rig const rig = sim::true_rig({});
    std::vector<drivers::HeightSample> heights;
    for (auto time = Timestamp {}; time < Timestamp(60s); time += 2ms) {
        double const turns = 2 * std::numbers::pi * to_seconds(time);
        double const counts = 2000 + 800 * std::sin(turns / 4) + 4 * std::sin(kTremor_hz * turns)
            + static_cast<double>(heights.size() * 7919 % 3);
        heights.push_back(
            { .time = time, .counts = static_cast<std::int32_t>(counts), .full_scale = 4095 });
    }
    for (auto _ : state) {
        calib::HeightMonitor monitor(rig);
        for (auto const& height : heights)
            monitor.push(height);
        benchmark::DoNotOptimize(monitor.present());
    }
    auto const count = static_cast<double>(heights.size());
    report(state,
           { .items = count, .item = "readings", .bytes = count * sizeof(drivers::HeightSample) });
}
BENCHMARK(watch_a_minute_of_heights);

void simulate_a_stroke(benchmark::State& state)
{
    sim::HelixShape const helix {
        .foot_mm = { 0, 0, 20 }, .radius_mm = 40, .end_radius_mm = 40, .turns = 3, .rise_mm = 300
    };
    sim::Hand const hand({ { .path = sim::make_path(helix) } }, {});
    double reports = 0;
    for (auto _ : state) {
        auto const run = sim::simulate_rig(hand, {});
        reports = static_cast<double>(run.tablet.reports.size() + run.height.reports.size());
        benchmark::DoNotOptimize(run.truth.data());
    }
    report(state,
           { .items = reports,
             .item = "reports",
             .bytes = reports * sizeof(drivers::RawReport),
             .limit = Limit::Fill });
}
BENCHMARK(simulate_a_stroke);

} // namespace
} // namespace tractus
