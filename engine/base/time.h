#pragma once

#include <chrono>
#include <cstdint>

namespace tractus {

using Duration = std::chrono::nanoseconds;

// Tags Timestamp. It has no now(): time comes with the data, and only drivers and app read a clock.
struct MonotonicClock {
    using duration = Duration;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<MonotonicClock, Duration>;
    // NOLINTNEXTLINE(readability-identifier-naming): std::chrono asks for this name.
    static constexpr bool is_steady = true;
};

// Nanoseconds of the monotonic clock, or since the start of a recording when read from a log.
using Timestamp = MonotonicClock::time_point;

constexpr Timestamp timestamp_ns(std::int64_t nanoseconds)
{
    return Timestamp(Duration(nanoseconds));
}

constexpr double to_seconds(Duration duration)
{
    return std::chrono::duration<double>(duration).count();
}

constexpr double to_seconds(Timestamp time)
{
    return to_seconds(time.time_since_epoch());
}

// The nearest nanosecond. |seconds| must be below 9e9.
constexpr Duration from_seconds(double seconds)
{
    return Duration(static_cast<std::int64_t>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5)));
}

} // namespace tractus
