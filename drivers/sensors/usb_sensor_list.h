#pragma once

#include "drivers/reports/device_info.h"

#include <filesystem>
#include <vector>

namespace tractus::drivers {

// Every height sensor on USB that is no HID device, in the order of their ports: the station's own
// kind, known by its interface's class, and LabJack's U3, known by its ids. Whether they can be
// opened or not: reads sysfs alone, for which no permission is needed. `location` is "usb:1-2.3".
std::vector<DeviceInfo> list_usb_height_sensors(std::filesystem::path const& folder
                                                = "/sys/bus/usb/devices");

} // namespace tractus::drivers
