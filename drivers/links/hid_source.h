#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// Every hidraw device that the kernel has, whether it can be opened or not, in the order of their
// nodes; `location` is the node. Reads sysfs alone, for which no permission is needed: a device
// whose files cannot be read comes without what they say. One physical tablet often has several
// nodes, for pen, pad and mouse.
std::vector<DeviceInfo> enumerate_hid(std::filesystem::path const& class_folder
                                      = "/sys/class/hidraw");

// Opens the hidraw device at `info.location`, through hidapi. Other readers, the kernel's own
// driver among them, go on as before. Times are of the monotonic clock, taken when a report has
// come; reports longer than a RawReport holds are left out and counted.
//
// Fails, as the user's fault, if the device is not there or may not be read and written, which the
// rules in drivers/70-tractus.rules permit. A read fails, as the device's fault, when it was
// unplugged.
Result<std::unique_ptr<ReportSource>> open_hid(DeviceInfo info);

} // namespace tractus::drivers
