#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace tractus::play {

// How a log's time runs beside a person's.
struct Pace {
    Timestamp data_begin {}; // This moment of the log…
    Timestamp real_begin {}; // …is played at this moment of the clock.
    double speed = 1;        // Above 0; 2 is twice as fast as it was recorded.

    std::function<Timestamp()> now;     // The clock.
    std::function<void(Duration)> wait; // Lets so much of it pass.

    // When a moment of the log comes.
    Timestamp real_time(Timestamp data) const;

    // The moment of the log that comes at one of the clock's.
    Timestamp data_time(Timestamp real) const;
};

// A pace by the monotonic clock that begins now.
Pace pace_from_now(Timestamp data_begin, double speed = 1);

// One device of a log as a source that sends its reports when their time has come, stamped with
// that time, as if the device were there. When the log is over, reading fails and says so.
// `log` is shared by the sources of its devices, each on a thread of its own; none changes it.
std::unique_ptr<drivers::ReportSource> open_paced(std::shared_ptr<drivers::Log const> log,
                                                  std::size_t device, Pace pace);

} // namespace tractus::play
