#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/event_pen.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

struct libevdev;

namespace tractus::drivers {

// Pens that Linux exposes only as input events, without a hidraw node: those of some Surface
// devices, and pens on serial lines, I2C and SPI. Their reports are made by EventPen and have the
// kernel's event times.

// Lists the pens without a hidraw node from sysfs; `root` is the root of the file system. A pen
// without read permission has no report descriptor.
std::vector<DeviceInfo> list_event_pens(std::filesystem::path const& root = "/");

// Opens the event node at `info.location`, such as "/dev/input/event5"; other readers keep
// receiving events. Fails with a user error if it cannot be opened or is not a pen. read() fails
// with a device error when the device is gone.
Result<std::unique_ptr<ReportSource>> open_event_pen(DeviceInfo info);

// The abilities that a device declares.
EventAbilities abilities_of(libevdev const& device);

} // namespace tractus::drivers
