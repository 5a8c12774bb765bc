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

// Pens that reach Linux as input events alone, since no HID driver is between: those of some
// Surfaces, and on serial lines, I2C and SPI. Their reports are an EventPen's, with the kernel's
// times of the events.

// The pens of which no hidraw node tells, by what sysfs says of them; `root` is the file system's.
// One that may not be read has no report descriptor.
std::vector<DeviceInfo> list_event_pens(std::filesystem::path const& root = "/");

// Opens the node at `info.location`, "/dev/input/event5". Others go on reading it as well. Fails,
// as the user's fault, if it cannot be opened or is no pen. A read fails, as the device's fault,
// when the device is gone.
Result<std::unique_ptr<ReportSource>> open_event_pen(DeviceInfo info);

// What a device says of itself.
EventAbilities abilities_of(libevdev const& device);

} // namespace tractus::drivers
