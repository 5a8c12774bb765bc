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

// Returns what is to be found without reading a device: permissions, drivers, unknown tablets,
// libraries. Empty if nothing is the matter.
std::vector<Finding> diagnose_system(SystemFacts const& facts);

// A device that the system permits, but that could not be opened.
Finding diagnose_refusal(drivers::DeviceInfo const& info, Error const& error);

// Returns what a device's reports show: a tablet in mouse mode or with unknown reports, a pen that
// never lifts, broken reports, a sensor's faults, times that go backwards. `listened` is how long
// it was listened to. Empty if nothing is the matter.
std::vector<Finding> diagnose_device(DeviceReading const& reading, Duration listened);

// The newest report of a sensor that sends text, as a terminal may show it; empty for others, and
// while there is none.
std::string newest_line(DeviceReading const& reading);

// Returns what the nodes of one tablet show together: touches that come on two of them, a mode that
// is lost where another node takes over. Empty if nothing is the matter.
std::vector<Finding> diagnose_together(std::span<DeviceReading const> readings);

// The machine's clocks at one instant.
struct ClockReading {
    Duration monotonic {}; // Our own: it stands while the machine sleeps.
    Duration boottime {};  // It goes on while the machine sleeps.
    Duration realtime {};  // The wall clock, which people and NTP set.
};

ClockReading read_clocks();

// Returns what happened to the clocks between two readings. Empty if nothing did.
std::vector<Finding> diagnose_clocks(ClockReading const& before, ClockReading const& after);

} // namespace tractus::diagnosis
