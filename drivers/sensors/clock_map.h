#pragma once

#include "engine/base/time.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace tractus::drivers {

// Tells the host's time of what a device stamped with its own 32-bit microsecond clock, from the
// times at which the device's messages arrived.
//
// A message is never early: it takes some least time, and then whatever USB and the scheduler add.
// So the line under all arrivals is the device's clock in the host's time, and what lies above it
// is jitter, which is forgotten. The line is the one that Moon, Skelly and Towsley choose
// ("Estimation and removal of clock skew from network delay measurements", INFOCOM 1999): of all
// lines that no arrival lies below, the one to which the arrivals of the last 32 s are closest in
// sum. The least time itself stays in the result, as a constant latency.
//
// A pure function of what it was told: the same messages give the same times.
class ClockMap {
public:
    // Whether the device's own numbers say that a message is one of the next after the last one.
    enum class Order { Follows, Unknown };

    // Adds a message: the device sent it at `device_us` of its clock, and it arrived at `arrival`.
    // False if the device's clock has begun anew since the last message, and with it the map: where
    // the order is not known, a clock is taken for a new one when it went back, or forward by half
    // a second more or less than the host's. Gaps of more than the clock's 71 minutes are no
    // reason.
    bool add(std::uint32_t device_us, Timestamp arrival, Order order);

    // Forgets everything: the next message is the first.
    void restart() { is_empty_ = true; }

    // The host's time at `device_us` of the device's clock, at most 35 minutes from the last
    // message that was added; there must be one.
    Timestamp host_time(std::uint32_t device_us) const;

    // How much the device's clock is slow, in parts of a million of its own time. 0 in the first
    // second.
    double drift_ppm() const { return slope_ * 1e3; }

private:
    // An arrival: when the device sent, and how much later than that the message came, both since
    // the first message.
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
    std::int64_t last_us_ = 0; // Since the first message, without wrapping.

    // The lowest arrival of each half second, in order of time; the last one is of the present half
    // second.
    std::array<Point, kWindows> lowest_ {};
    std::size_t count_ = 0;
    std::int64_t window_end_us_ = 0;

    double slope_ = 0;     // Nanoseconds of delay per microsecond.
    double offset_ns_ = 0; // Height of the line at the first message.
};

} // namespace tractus::drivers
