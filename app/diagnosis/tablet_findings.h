#pragma once

#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// Describes a device as "Wacom CTL-472 (056a:037a) at /dev/hidraw3".
std::string device_subject(drivers::DeviceInfo const& info);

// True if the ids belong to a known tablet, or if the vendor is a maker of tablets.
bool is_tablet(std::uint16_t vendor_id, std::uint16_t product_id);

// Explains what must be known about an unsupported tablet to support it, one line each.
std::vector<std::string> describe_needed_information(drivers::DeviceInfo const& info);

// Appends problems in a pen's reports: mouse mode from the beginning or since a certain time,
// unknown reports, and a tip that never lifts.
void diagnose_pen(DeviceReading const& reading, std::vector<Finding>& findings);

// Appends problems that show only in several device nodes of one tablet: the same touches reported
// on two nodes, and a mode that is lost when another node takes over.
void diagnose_nodes(std::span<DeviceReading const> readings, std::vector<Finding>& findings);

} // namespace tractus::diagnosis
