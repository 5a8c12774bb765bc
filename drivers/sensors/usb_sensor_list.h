#pragma once

#include "drivers/reports/device_info.h"

#include <filesystem>
#include <vector>

namespace tractus::drivers {

// Lists the USB height sensors that are not HID devices, sorted by port: the station's own kind,
// recognised by its interface class, and LabJack's U3, recognised by its ids. Includes devices that
// may not be opened, since only sysfs is read, which needs no permission. `location` is
// "usb:1-2.3".
std::vector<DeviceInfo> list_usb_height_sensors(std::filesystem::path const& folder
                                                = "/sys/bus/usb/devices");

} // namespace tractus::drivers
