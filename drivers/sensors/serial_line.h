#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// A height sensor on a serial line: an Arduino, ESP32 or RP2040 that prints one number a line
// (firmware-notes/serial.md; number_line.h has what a line may hold). It is read only where its
// address names it, since whatever else may be on such a line.
//
// Settings, behind the @ of its address: the baud rate, 115200 by itself, and the greatest number,
// max=4095 by itself: "/dev/ttyACM0@9600,max=1023". Boards with USB of their own do not mind the
// baud rate.

// The serial lines over USB (ttyACM, ttyUSB) that the kernel has.
std::vector<DeviceInfo> list_serial_lines(std::filesystem::path const& tty_folder
                                          = "/sys/class/tty");

// Describes the line at a node, listed or not. Fails, as the user's fault, if there is no node.
Result<DeviceInfo> describe_serial_line(std::string const& node);

// Opens the node at `info.location`, and takes it for itself. A report is a line, without its line
// break, when it ended; the first one may have begun before and is left out, empty ones are, too.
// Fails, as the user's fault, for settings that are none and for a node that cannot be opened. A
// read fails, as the device's fault, when the device is gone.
Result<std::unique_ptr<ReportSource>> open_serial_line(DeviceInfo info);

// Whether a device, opened or from a log, is one of these.
bool is_serial_line(DeviceInfo const& info);

// The decoder of its reports; `info` must be one of these. Fails, as the user's fault, if a log has
// settings that are none.
Result<std::unique_ptr<HeightDecoder>> make_serial_line_decoder(DeviceInfo const& info);

} // namespace tractus::drivers
