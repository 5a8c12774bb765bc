#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace tractus::play {

// Mapping between the time in a log and the time of a clock.
struct Pace {
    Timestamp data_begin {}; // Time in the log that is played at real_begin.
    Timestamp real_begin {}; // Time of the clock at which data_begin is played.
    double speed = 1;        // Playback speed, greater than 0; 2 is twice the recorded speed.

    std::function<Timestamp()> now;     // Returns the clock's time.
    std::function<void(Duration)> wait; // Waits for a duration, measured by the clock.

    // Returns the time of the clock at which a time in the log is played.
    Timestamp real_time(Timestamp data) const;

    // Returns the time in the log that is played at a time of the clock.
    Timestamp data_time(Timestamp real) const;
};

// Returns a pace on the monotonic clock that starts now.
Pace pace_from_now(Timestamp data_begin, double speed = 1);

// Returns a source that plays one device of a log as if it were connected: each report arrives when
// it is due, with that time as its time stamp. After the end of the log, reading fails with a
// message that says so. The log is shared by the sources of all its devices, each read on a thread
// of its own, and must not change.
std::unique_ptr<drivers::ReportSource> open_paced(std::shared_ptr<drivers::Log const> log,
                                                  std::size_t device, Pace pace);

} // namespace tractus::play
