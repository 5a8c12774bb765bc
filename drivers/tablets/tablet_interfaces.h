#pragma once

#include "drivers/reports/device_info.h"

#include <vector>

namespace tractus::drivers {

// True if the device sends pen reports that the program can decode.
bool carries_pen(DeviceInfo const& info);

// Groups HID devices by the physical device that they belong to, in the order of their first
// members. A tablet may have separate interfaces for the pen, its keys and its maker's own reports.
// Which of them carry pen data, and when, depends on its mode, so all that may do so must be
// opened.
std::vector<std::vector<DeviceInfo>> group_by_tablet(std::vector<DeviceInfo> const& devices);

} // namespace tractus::drivers
