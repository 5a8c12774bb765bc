#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// A height sensor on a serial port: an Arduino, ESP32 or RP2040 that prints one number per line
// (firmware-notes/serial.md; number_line.h specifies the lines). It is read only if the user names
// its address, since any device may be on a serial port.
//
// Settings, after the @ of the address: the baud rate, 115200 by default, and the greatest number,
// max=4095 by default: "/dev/ttyACM0@9600,max=1023". Boards with native USB ignore the baud rate.

// Lists the kernel's serial ports over USB (ttyACM, ttyUSB).
std::vector<DeviceInfo> list_serial_lines(std::filesystem::path const& tty_folder
                                          = "/sys/class/tty");

// Describes the serial port at a node, listed or not. Fails with a user error if the node does
// not exist.
Result<DeviceInfo> describe_serial_line(std::string const& node);

// Opens the node at `info.location` exclusively. A report is a line without its line break, with
// the time at which it ended. The first line, which may be incomplete, and empty lines are dropped.
// Fails with a user error for invalid settings and for a node that cannot be opened. A read
// fails with a device error when the device is gone.
Result<std::unique_ptr<ReportSource>> open_serial_line(DeviceInfo info);

// True if a device, live or from a log, is a serial height sensor.
bool is_serial_line(DeviceInfo const& info);

// Makes the decoder of a serial sensor's reports; `info` must satisfy is_serial_line(). Fails with
// a user error if the settings in a log are invalid.
Result<std::unique_ptr<HeightDecoder>> make_serial_line_decoder(DeviceInfo const& info);

} // namespace tractus::drivers
