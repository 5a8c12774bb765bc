#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Opens a HID device: "/dev/hidraw3" through hidraw, "libusb:1-2.3:0" through hidapi's libusb back
// end (see drivers/tablets/hidapi_libusb.h). A tablet in the table is switched to its full mode
// (see drivers/tablets/mode_switch.h) before its first report is read; a report that another
// interface of the tablet accepts is sent there. The source's info() contains the strings that were
// read and, in `warnings`, what failed.
//
// For a libusb address, the ids, the name and the report descriptor are read from the device
// itself, so they are not changed by Linux's driver.
//
// Fails like open_hid().
Result<std::unique_ptr<ReportSource>> open_tablet(DeviceInfo info);

} // namespace tractus::drivers
