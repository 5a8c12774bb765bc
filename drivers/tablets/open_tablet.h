#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Opens a HID device: at "/dev/hidraw3" through hidraw, at "libusb:1-2.3:0" through hidapi's libusb
// back end (see drivers/tablets/hidapi_libusb.h). If the table knows it as a tablet, it is switched
// to its full mode (see drivers/tablets/mode_switch.h) before its first report is read; a report
// that another interface of the tablet takes is sent there. The source's info() has the strings
// that were read, and in `warnings` what did not go well.
//
// The ids, the name and the report descriptor of a libusb address are read from the device, as it
// has them itself, whatever Linux's driver has made of it.
//
// Fails as open_hid does.
Result<std::unique_ptr<ReportSource>> open_tablet(DeviceInfo info);

} // namespace tractus::drivers
