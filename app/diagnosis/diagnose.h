#pragma once

#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"
#include "app/diagnosis/system_facts.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <span>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// Finds problems that show without reading from devices: missing permissions, interfering drivers,
// unknown tablets, old libraries. Empty if there are none.
std::vector<Finding> diagnose_system(SystemFacts const& facts);

// Reports a device that the user may open but that could not be opened.
Finding diagnose_refusal(drivers::DeviceInfo const& info, Error const& error);

// Finds problems in a device's reports: a tablet in mouse mode or with unknown reports, a pen that
// never lifts, invalid reports, sensor faults, times that go backwards. `listened` is the time for
// which reports were collected. Empty if there are none.
std::vector<Finding> diagnose_device(DeviceReading const& reading, Duration listened);

// Returns the newest report of a sensor that sends text, with characters that a terminal can print.
// Empty for other devices, and before the first report.
std::string newest_line(DeviceReading const& reading);

// Finds problems that show only in several device nodes of one tablet: the same touches reported on
// two nodes, or a mode that is lost when another node takes over. Empty if there are none.
std::vector<Finding> diagnose_together(std::span<DeviceReading const> readings);

// The machine's clocks, read at the same instant.
struct ClockReading {
    Duration monotonic {}; // The clock that the program uses; it stops while the machine sleeps.
    Duration boottime {};  // A clock that continues while the machine sleeps.
    Duration realtime {};  // The wall clock, which the user and NTP can set.
};

ClockReading read_clocks();

// Reports if the machine slept or a clock was set between two readings. Empty if neither happened.
std::vector<Finding> diagnose_clocks(ClockReading const& before, ClockReading const& after);

} // namespace tractus::diagnosis
