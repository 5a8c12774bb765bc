#pragma once

#include <chrono>
#include <cstdint>

namespace tractus {

using Duration = std::chrono::nanoseconds;

// The clock type of Timestamp. It has no now(): times come with the data, and only the drivers and
// the application read a clock.
struct MonotonicClock {
    using duration = Duration;
    using rep = duration::rep;
    using period = duration::period;
    using time_point = std::chrono::time_point<MonotonicClock, Duration>;
    // NOLINTNEXTLINE(readability-identifier-naming): std::chrono requires this name.
    static constexpr bool is_steady = true;
};

// A time in nanoseconds of the monotonic clock, or since the start of the recording if read from a
// log.
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

// Rounds to the nearest nanosecond. |seconds| must be below 9e9.
constexpr Duration from_seconds(double seconds)
{
    return Duration(static_cast<std::int64_t>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5)));
}

} // namespace tractus
