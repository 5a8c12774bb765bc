#include "sim/simulated_device.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::sim {
namespace {

using namespace std::chrono_literals;

SimulatedDevice device_with_reports_at(std::initializer_list<Duration> times)
{
    SimulatedDevice device;
    for (auto const time : times)
        device.reports.push_back({ .received = Timestamp(time), .size = 1 });
    return device;
}

TEST(DeviceClock, MeasuresAtARegularPaceAndReportsLater)
{
    DeviceClock clock({ .period = 5ms, .latency = 8ms, .jitter = 400us }, { .seed = 1 });
    double sum_s = 0;
    double sum_of_squares_s = 0;
    auto before = clock.next_instant();
    constexpr int kCount = 1000;
    for (int i = 0; i < kCount; ++i) {
        auto const instant = clock.next_instant();
        EXPECT_EQ(instant - before, 5ms);
        before = instant;
        double const late_s = to_seconds(clock.arrival(instant) - instant) - 0.008;
        sum_s += late_s;
        sum_of_squares_s += late_s * late_s;
    }
    EXPECT_NEAR(sum_s / kCount, 0, 50e-6);
    EXPECT_NEAR(std::sqrt(sum_of_squares_s / kCount), 400e-6, 40e-6);
}

TEST(DeviceClock, ReportsNeverOvertakeEachOther)
{
    DeviceClock clock({ .period = 1ms, .latency = 5ms, .jitter = 3ms }, { .seed = 1 });
    Timestamp before {};
    for (int i = 0; i < 1000; ++i) {
        auto const instant = clock.next_instant();
        auto const arrival = clock.arrival(instant);
        EXPECT_GT(arrival, before);
        EXPECT_GE(arrival, instant);
        before = arrival;
    }
}

TEST(SimulatedSource, GivesReportsAsFastAsTheyAreRead)
{
    auto const source = open_simulated(device_with_reports_at({ 1ms, 2s }));
    EXPECT_EQ(source->read(0ms).value()->received, Timestamp(1ms));
    EXPECT_EQ(source->read(0ms).value()->received, Timestamp(2s));
    EXPECT_FALSE(source->read(0ms).value());
}

TEST(SimulatedSource, GivesReportsWhenItsPacerSaysSo)
{
    Timestamp now {};
    auto const wait = [&](Timestamp due, Duration timeout) {
        now = std::min(due, now + timeout);
        return now == due;
    };
    auto const source = open_simulated(device_with_reports_at({ 1ms, 25ms }), wait);
    EXPECT_EQ(source->read(10ms).value()->received, Timestamp(1ms));
    EXPECT_FALSE(source->read(10ms).value());
    EXPECT_FALSE(source->read(10ms).value());
    EXPECT_EQ(source->read(10ms).value()->received, Timestamp(25ms));
    EXPECT_FALSE(source->read(10ms).value());
    EXPECT_EQ(now, Timestamp(35ms));
}

TEST(SimulatedDevices, ReportsMergeInOrderOfArrival)
{
    auto const a = device_with_reports_at({ 1ms, 5ms, 9ms });
    auto const b = device_with_reports_at({ 2ms, 5ms });
    std::vector<std::pair<std::size_t, Duration>> merged;
    for (auto const& arrived : in_order_of_arrival(std::array { &a, &b }))
        merged.emplace_back(arrived.device, arrived.report->received.time_since_epoch());
    std::vector<std::pair<std::size_t, Duration>> const expected {
        { 0, 1ms }, { 1, 2ms }, { 0, 5ms }, { 1, 5ms }, { 0, 9ms }
    };
    EXPECT_EQ(merged, expected);
}

} // namespace
} // namespace tractus::sim
