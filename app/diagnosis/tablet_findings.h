#pragma once

#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// Describes a device: "Wacom CTL-472 (056a:037a) at /dev/hidraw3".
std::string device_subject(drivers::DeviceInfo const& info);

// True if the ids belong to a known tablet or to another device of a tablet maker.
bool is_tablet(std::uint16_t vendor_id, std::uint16_t product_id);

// Explains what information about an unsupported tablet is needed, one line each.
std::vector<std::string> describe_needed_information(drivers::DeviceInfo const& info);

// Appends problems in a pen's reports: mouse mode from the beginning or from some moment on,
// unknown reports, and a tip that never lifts.
void diagnose_pen(DeviceReading const& reading, std::vector<Finding>& findings);

// Appends problems that several nodes of one tablet show together: touches reported on two of them,
// and a mode that is lost when another node takes over.
void diagnose_nodes(std::span<DeviceReading const> readings, std::vector<Finding>& findings);

} // namespace tractus::diagnosis
