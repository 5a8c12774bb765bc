#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Lists every device that can be discovered: HID devices by their hidraw nodes, pens without a
// hidraw node by their event nodes, then USB height sensors, USB serial ports, and channels of
// industrial I/O. Devices on GPIO lines cannot be discovered and must be named by their address.
// Listing needs no permissions. Thread-safe.
std::vector<DeviceInfo> list_devices();

// Lists devices under every address by which they can be opened. A USB tablet appears under its
// node and, at the end of the list, also under its "libusb:" address (list_usb_tablets()).
std::vector<DeviceInfo> list_device_addresses();

// Describes the device at an address (see drivers/reports/device_address.h). A device on GPIO lines
// is described by its address alone. Fails with a user error if the text is not an address or
// there is no device.
//
// An @ may be followed by settings, which some height sensors have:
//   /dev/hidraw3@GP2,4.096V   MCP2221A: the wiper's pin, GP1 to GP3, and the reference,
//                             VDD, 1.024V, 2.048V or 4.096V; default: GP1 and VDD
//   usb:1-2@AIN3              LabJack U3: the wiper's input, AIN0 to AIN15; default: AIN0
//   usb:1-2@2000us,internal   the station's own kind: the time between readings, and the reference,
//                             supply or internal; default: the sensor's settings
//   /dev/ttyACM0@9600,max=1023     serial sensor: drivers/sensors/serial_line.h
//   iio:ads1015:voltage0@max=2047  industrial I/O: drivers/sensors/iio_channel.h
Result<DeviceInfo> find_device(std::string_view address);

// Opens a device with the driver for its location and ids. Thread-safe: devices are opened one at a
// time, because the underlying libraries cannot open several at once. Fails with a user error for a
// malformed location, and for settings of a device that has none; also fails if the driver does.
Result<std::unique_ptr<ReportSource>> open_device(DeviceInfo info);

} // namespace tractus::drivers
