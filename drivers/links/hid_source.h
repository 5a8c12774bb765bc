#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// Lists every hidraw device of the kernel, in the order of nodes, whether or not it can be opened;
// `location` is the node. Reads only sysfs, which needs no permissions; fields whose files cannot
// be read stay empty. One tablet often has several nodes, for pen, pad and mouse.
std::vector<DeviceInfo> enumerate_hid(std::filesystem::path const& class_folder
                                      = "/sys/class/hidraw");

// Opens the hidraw device at `info.location` through hidapi. Other readers, including the kernel's
// driver, are not affected. Reports are stamped on arrival by the monotonic clock; those longer
// than a RawReport are dropped and counted.
//
// Fails with a user error if the device is missing or lacks the permissions that
// drivers/70-tractus.rules grants. read() fails with a device error after unplugging.
Result<std::unique_ptr<ReportSource>> open_hid(DeviceInfo info);

} // namespace tractus::drivers
