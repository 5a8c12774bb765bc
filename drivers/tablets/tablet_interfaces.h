#pragma once

#include "drivers/reports/device_info.h"

#include <vector>

namespace tractus::drivers {

// Whether the device sends a pen's reports, of which we know what they say.
bool carries_pen(DeviceInfo const& info);

// HID devices by the physical device that they are interfaces of, in the order of their first ones.
// A tablet may have one for the pen, one for its keys and one for its maker's own reports; which of
// them carry a pen, and when, depends on its mode, so all that may are to be opened.
std::vector<std::vector<DeviceInfo>> group_by_tablet(std::vector<DeviceInfo> const& devices);

} // namespace tractus::drivers
