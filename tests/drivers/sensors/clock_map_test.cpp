#include "drivers/sensors/clock_map.h"

#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;
using Order = ClockMap::Order;

// A device that sends every millisecond by its own clock, and a host that receives it with delays.
struct SimulatedClock {
    double drift_ppm = 0;          // Parts per million by which the device's clock is slow.
    std::uint32_t first_us = 1000; // The device's clock when the host's time is 0.
    double jitter_us = 0;          // Mean delay in addition to the minimum transmission time.
    double stall_ms = 0;           // Duration of occasional stalls of the host.
    Random random { { .seed = 1 } };
    Timestamp last {}; // Last arrival; messages do not overtake each other.

    static constexpr Duration kMinTime = 300us;

    std::uint32_t device_us(Timestamp host) const
    {
        return first_us
            + static_cast<std::uint32_t>(
                   std::llround(to_seconds(host) * 1e6 / (1 + drift_ppm * 1e-6)));
    }

    Timestamp arrival(Timestamp sent)
    {
        double late_us = -jitter_us * std::log(1 - random.uniform());
        if (stall_ms > 0 && random.next_u32() % 500 == 0)
            late_us += stall_ms * 1000;
        last = std::max(last, sent + kMinTime + from_seconds(late_us * 1e-6));
        return last;
    }
};

// The least and the greatest error of the mapped times, in microseconds, after subtracting the
// minimum transmission time.
struct Span {
    double min_us = std::numeric_limits<double>::max();
    double greatest_us = std::numeric_limits<double>::lowest();
};

Span run(ClockMap& map, SimulatedClock& clock, Timestamp from, Timestamp to)
{
    Span span;
    for (auto sent = Timestamp(1ms); sent < to; sent += 1ms) {
        auto const device_us = clock.device_us(sent);
        EXPECT_TRUE(map.add(device_us, clock.arrival(sent), Order::Follows));
        auto const error = map.host_time(device_us) - sent - SimulatedClock::kMinTime;
        if (sent < from)
            continue;
        span.min_us = std::min(span.min_us, to_seconds(error) * 1e6);
        span.greatest_us = std::max(span.greatest_us, to_seconds(error) * 1e6);
    }
    return span;
}

TEST(ClockMap, FirstMessageIsWhenItArrived)
{
    ClockMap map;
    EXPECT_TRUE(map.add(123, timestamp_ns(7'000'000), Order::Unknown));
    EXPECT_EQ(map.host_time(123), timestamp_ns(7'000'000));
    EXPECT_EQ(map.host_time(23), timestamp_ns(6'900'000));
    EXPECT_EQ(map.host_time(124), timestamp_ns(7'001'000));
}

TEST(ClockMap, JitterDoesNotMoveTimes)
{
    ClockMap map;
    SimulatedClock clock { .jitter_us = 500 };
    auto const span = run(map, clock, Timestamp(2s), Timestamp(30s));
    EXPECT_GT(span.min_us, -1.5); // The device counts whole microseconds.
    EXPECT_LT(span.greatest_us, 20);
}

TEST(ClockMap, FollowsAClockThatDrifts)
{
    for (double const drift_ppm : { -200.0, 200.0, 2000.0 }) {
        ClockMap map;
        SimulatedClock clock { .drift_ppm = drift_ppm, .jitter_us = 500 };
        auto const span = run(map, clock, Timestamp(3s), Timestamp(60s));
        EXPECT_GT(span.min_us, -20) << drift_ppm;
        EXPECT_LT(span.greatest_us, 20) << drift_ppm;
        EXPECT_NEAR(map.drift_ppm(), drift_ppm, 2);
    }
}

TEST(ClockMap, IsAHalfMillisecondRightFromTheStart)
{
    ClockMap map;
    SimulatedClock clock { .drift_ppm = 200, .jitter_us = 200 };
    auto const span = run(map, clock, Timestamp(100ms), Timestamp(3s));
    EXPECT_GT(span.min_us, -500);
    EXPECT_LT(span.greatest_us, 100);
}

TEST(ClockMap, ForgivesAHostThatLooksAway)
{
    ClockMap map;
    SimulatedClock clock { .drift_ppm = 200, .jitter_us = 100, .stall_ms = 80 };
    auto const span = run(map, clock, Timestamp(3s), Timestamp(30s));
    EXPECT_GT(span.min_us, -20);
    EXPECT_LT(span.greatest_us, 20);
}

TEST(ClockMap, CountsOnWhenTheDevicesCounterWraps)
{
    ClockMap map;
    SimulatedClock clock { .drift_ppm = 50, .first_us = 0xFFFF'FFFF - 5'000'000, .jitter_us = 100 };
    auto const span = run(map, clock, Timestamp(3s), Timestamp(20s));
    EXPECT_GT(span.min_us, -20);
    EXPECT_LT(span.greatest_us, 20);
}

TEST(ClockMap, AGapOfHoursIsNoNewClock)
{
    ClockMap map;
    map.add(1000, Timestamp(0s), Order::Unknown);
    // The counter wraps after 4294.967296 s.
    auto const three_hours = Timestamp(10'800s);
    auto const device_us = static_cast<std::uint32_t>(10'800'000'000 + 1000);
    EXPECT_TRUE(map.add(device_us, three_hours, Order::Unknown));
    EXPECT_EQ(map.host_time(device_us), three_hours);
}

TEST(ClockMap, AClockThatBeginsAnewIsANewClock)
{
    ClockMap map;
    map.add(60'000'000, Timestamp(100s), Order::Unknown);
    EXPECT_TRUE(map.add(60'001'000, Timestamp(100s + 1ms), Order::Follows));
    EXPECT_FALSE(map.add(5'000, Timestamp(102s), Order::Unknown));
    EXPECT_EQ(map.host_time(5'000), Timestamp(102s));
}

TEST(ClockMap, ALateMessageOfTheSameRowIsNoNewClock)
{
    ClockMap map;
    map.add(1000, Timestamp(0s), Order::Unknown);
    EXPECT_TRUE(map.add(2000, Timestamp(3s), Order::Follows));
    EXPECT_EQ(map.host_time(2000), Timestamp(1ms));
}

TEST(ClockMap, DoesNotDependOnWhenTheHostsClockBegan)
{
    ClockMap early;
    ClockMap late;
    SimulatedClock clock { .drift_ppm = 120, .jitter_us = 300 };
    auto const shift = Duration(1'234'567'890'123'456);
    for (auto sent = Timestamp(1ms); sent < Timestamp(5s); sent += 1ms) {
        auto const device_us = clock.device_us(sent);
        auto const arrival = clock.arrival(sent);
        early.add(device_us, arrival, Order::Follows);
        late.add(device_us, arrival + shift, Order::Follows);
        ASSERT_EQ(late.host_time(device_us) - early.host_time(device_us), shift);
    }
}

} // namespace
} // namespace tractus::drivers
