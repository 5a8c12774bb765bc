#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace tractus::play {

// Mapping between the time of a log and a clock.
struct Pace {
    Timestamp data_begin {}; // Time of the log that is played at real_begin.
    Timestamp real_begin {}; // Time of the clock at which data_begin is played.
    double speed = 1;        // Greater than 0; 2 is twice the recorded speed.

    std::function<Timestamp()> now;     // Returns the clock's time.
    std::function<void(Duration)> wait; // Waits for a duration of the clock.

    // Clock time at which a moment of the log is played.
    Timestamp real_time(Timestamp data) const;

    // Moment of the log that is played at a clock time.
    Timestamp data_time(Timestamp real) const;
};

// A pace on the monotonic clock that starts now.
Pace pace_from_now(Timestamp data_begin, double speed = 1);

// A source that plays one device of a log: its reports arrive when due, stamped with that time, as
// if the device were connected. After the end of the log, reading fails with a message that says
// so. The immutable `log` is shared by the sources of its devices, each on a thread of its own.
std::unique_ptr<drivers::ReportSource> open_paced(std::shared_ptr<drivers::Log const> log,
                                                  std::size_t device, Pace pace);

} // namespace tractus::play
