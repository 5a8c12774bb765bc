#pragma once

#include "engine/base/time.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace tractus::drivers {

// Converts time stamps of a device's 32-bit microsecond clock to the host's time, from the times at
// which the device's messages arrived.
//
// A message takes a minimum transmission time plus whatever USB and the scheduler add; it is never
// early. The line below all arrivals therefore represents the device's clock in the host's time,
// and the distance above it is jitter, which is ignored. The line is chosen by the method of Moon,
// Skelly and Towsley ("Estimation and removal of clock skew from network delay measurements",
// INFOCOM 1999): of all lines with no arrival below, the one with the smallest sum of distances to
// the arrivals of the last 32 s. The minimum transmission time remains in the result as a constant
// latency.
//
// The result depends only on the messages added: equal messages give equal times.
class ClockMap {
public:
    // Whether the device's sequence numbers show that a message follows the last one.
    enum class Order { Follows, Unknown };

    // Adds a message that the device sent at `device_us` of its clock and that arrived at
    // `arrival`. Returns false, and restarts the map, if the device's clock has restarted since the
    // last message. If the order is unknown, a restart is assumed when the clock went back, or
    // differs by half a second from the host's progress. Gaps longer than the clock's period of 71
    // minutes are accepted.
    bool add(std::uint32_t device_us, Timestamp arrival, Order order);

    // Forgets everything: the next message counts as the first.
    void restart() { is_empty_ = true; }

    // Returns the host's time at `device_us` of the device's clock, which must be within 35 minutes
    // of the last message. At least one message must have been added.
    Timestamp host_time(std::uint32_t device_us) const;

    // Rate by which the device's clock is slow, in parts per million of the device's own time. 0
    // during the first second.
    double drift_ppm() const { return slope_ * 1e3; }

private:
    // Arrival of one message. `sent_us` is when the device sent it, counted from the first message;
    // `delay_ns` is by how much longer than the first message it was under way.
    struct Point {
        std::int64_t sent_us = 0;
        std::int64_t delay_ns = 0;
    };
    static constexpr std::size_t kWindows = 64;

    void begin(std::uint32_t device_us, Timestamp arrival);
    bool advance(std::uint32_t device_us, Timestamp arrival, Order order);
    double above_line(Point const& point) const;
    void fit();

    bool is_empty_ = true;
    Timestamp first_arrival_ {};
    std::uint32_t first_us_ = 0;
    Timestamp last_arrival_ {};
    std::int64_t last_us_ = 0; // Device time since the first message, without wrapping.

    // The lowest arrival of each half second, oldest first; the last entry is for the current half
    // second.
    std::array<Point, kWindows> lowest_ {};
    std::size_t count_ = 0;
    std::int64_t window_end_us_ = 0;

    double slope_ = 0;     // Slope of the line: nanoseconds of delay per microsecond.
    double offset_ns_ = 0; // Delay of the line at the first message.
};

} // namespace tractus::drivers
