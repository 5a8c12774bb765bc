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

// Finds problems without reading from devices: permissions, drivers, unknown tablets, libraries.
// Empty if there are none.
std::vector<Finding> diagnose_system(SystemFacts const& facts);

// Reports a device that the system permits but that could not be opened.
Finding diagnose_refusal(drivers::DeviceInfo const& info, Error const& error);

// Finds problems in a device's reports: a tablet in mouse mode or with unknown reports, a pen that
// never lifts, invalid reports, sensor faults, times that go backwards. `listened` is the length of
// the observation. Empty if there are none.
std::vector<Finding> diagnose_device(DeviceReading const& reading, Duration listened);

// The newest report of a text-sending sensor, made safe for a terminal; empty for other devices and
// before the first report.
std::string newest_line(DeviceReading const& reading);

// Finds problems that several nodes of one tablet show together: touches reported on two of them,
// or a mode that is lost when another node takes over. Empty if there are none.
std::vector<Finding> diagnose_together(std::span<DeviceReading const> readings);

// The machine's clocks, read at one instant.
struct ClockReading {
    Duration monotonic {}; // The program's own clock; it stops while the machine sleeps.
    Duration boottime {};  // A clock that also counts while the machine sleeps.
    Duration realtime {};  // The wall clock, which users and NTP can set.
};

ClockReading read_clocks();

// Reports whether the machine slept or a clock was set between two readings. Empty if not.
std::vector<Finding> diagnose_clocks(ClockReading const& before, ClockReading const& after);

} // namespace tractus::diagnosis
