#pragma once

#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// "Wacom CTL-472 (056a:037a) at /dev/hidraw3"
std::string device_subject(drivers::DeviceInfo const& info);

// Whether the ids are of a tablet that is known, or of another device of somebody who makes
// tablets.
bool is_tablet(std::uint16_t vendor_id, std::uint16_t product_id);

// What a tablet that nobody knows should be asked for, a line each.
std::vector<std::string> how_to_describe_it(drivers::DeviceInfo const& info);

// Appends what a pen's reports show: mouse mode, from the beginning or in mid-recording, unknown
// reports, and a tip that never lifts.
void diagnose_pen(DeviceReading const& reading, std::vector<Finding>& findings);

// Appends what the nodes of one tablet show together: touches that come on two of them, and a mode
// that is lost where another node takes over.
void diagnose_nodes(std::span<DeviceReading const> readings, std::vector<Finding>& findings);

} // namespace tractus::diagnosis
