#pragma once

#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <istream>
#include <optional>
#include <string_view>

namespace tractus::drivers {

// Recordings by other programs, as logs. Their times are rebased to the first report. What does not
// fit is skipped with a warning, as by parse_log; `name` is what messages call the text. Of the
// text no more than a line is kept; what holds more than kMostPipedLogBytes of reports is refused,
// and so is a line of more than 1 MiB.

// Reads what usbhid-dump prints with --entity=all or --entity=stream: for each interface of a USB
// device its descriptor, then one block per transfer,
//
//   003:005:001:STREAM             1436110030.141241
//    08 80 10 27 10 27 00 00
//
// with a blank line behind it. It names neither device nor ids. Without a DESCRIPTOR block an
// interface has no report descriptor. Fails, as the user's fault, if there is no block at all.
Result<Log> parse_usbhid_dump(std::istream& in, std::string_view name);

// Whether a line is the first of such a block.
bool begins_usbhid_dump_block(std::string_view line);

// What `libinput record` writes, best with --with-hidraw (YAML): the report descriptor of each
// device ("hid") and the raw reports among its events. Where there are no raw reports of a pen, its
// input events stand for them (drivers/reports/event_pen.h). Fails, as the user's fault, if it is
// not YAML, or if no device has raw reports and none is a pen.
Result<Log> parse_libinput_record(std::istream& in, std::string_view name);

// What evemu-record writes of a pen, versions 1.0 to 1.3: the kernel's input events, which become
// reports of a HID pen (drivers/reports/event_pen.h). Fails, as the user's fault, if the device is
// no pen.
Result<Log> parse_evemu(std::istream& in, std::string_view name);

// Whether a line is the first that tells such a recording from a hid-recorder file.
bool begins_evemu_recording(std::string_view line);

enum class LogFormat {
    TractusLog, // Hid-recorder's too, of which it is a superset.
    UsbhidDump,
    LibinputRecord,
    Evemu,
};

// Tells from the first lines of a text, or of a regular file. No value where none of them tells, or
// none can be read.
std::optional<LogFormat> guess_log_format(std::string_view text);
std::optional<LogFormat> guess_file_format(std::filesystem::path const& path);

} // namespace tractus::drivers
