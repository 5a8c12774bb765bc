#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Every device that can be found without being told where: HID devices by their hidraw nodes, pens
// that have none by their event nodes, then
// the USB devices that are height sensors, serial lines over USB, and channels of industrial I/O.
// What is on GPIO lines cannot be found, and is named by its address. Needs no permission. Safe to
// call from any thread.
std::vector<DeviceInfo> list_devices();

// Lists devices by every address that can be opened: a tablet on USB stands there by its node and,
// at the end, by its "libusb:" address as well, as list_usb_tablets has it.
std::vector<DeviceInfo> list_device_addresses();

// Returns what is known of the device at an address (see drivers/device_address.h). A GPIO
// converter is known by its address alone. Fails, as the user's fault, if the text is no address or
// nothing is there.
//
// Behind an @ may stand settings, of which height sensors know some:
//   /dev/hidraw3@GP2,4.096V   MCP2221A: the wiper's pin, GP1 to GP3, and the reference,
//                             VDD, 1.024V, 2.048V or 4.096V; GP1 and VDD by itself
//   usb:1-2@AIN3              LabJack U3: the wiper's input, AIN0 to AIN15; AIN0 by itself
//   usb:1-2@2000us,internal   the station's own kind: the time between readings, and the reference,
//                             supply or internal; what the sensor has by itself
//   /dev/ttyACM0@9600,max=1023  a line of numbers: drivers/sensors/serial_line.h
//   iio:ads1015:voltage0@max=2047  drivers/sensors/iio_channel.h
Result<DeviceInfo> find_device(std::string_view address);

// Opens a device with the driver that its location and ids ask for. Safe to call from any thread,
// since the libraries' own opening is not: one device at a time is opened. Fails, as the user's
// fault, for a location that is no address and for settings of a device that has none, and as the
// driver does.
Result<std::unique_ptr<ReportSource>> open_device(DeviceInfo info);

} // namespace tractus::drivers
