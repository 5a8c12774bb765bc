#pragma once

#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <istream>
#include <optional>
#include <string_view>

namespace tractus::drivers {

// Readers of recordings by other programs, which return logs. Times are rebased to the first
// report. Malformed parts are skipped with a warning, as by parse_log(); `name` identifies the text
// in messages. No more than one line of text is kept in memory. A recording with more than
// kMaxPipedLogBytes of reports, or a line of more than 1 MiB, is refused.

// Reads the output of usbhid-dump with --entity=all or --entity=stream: the descriptor of each
// interface of a USB device, then one block for each transfer,
//
//   003:005:001:STREAM             1436110030.141241
//    08 80 10 27 10 27 00 00
//
// followed by a blank line. It contains neither names nor ids. An interface without a DESCRIPTOR
// block has no report descriptor. Fails with a user error if there is no block at all.
Result<Log> parse_usbhid_dump(std::istream& in, std::string_view name);

// True if the line can be the head of a block written by usbhid-dump.
bool begins_usbhid_dump_block(std::string_view line);

// Reads what `libinput record` writes (YAML), best with --with-hidraw: the report descriptor of
// each device ("hid") and the raw reports among its events. For a pen without raw reports, its
// input events are used instead (drivers/reports/event_pen.h). Fails with a user error if the
// text is not YAML, or if no device has raw reports and none is a pen.
Result<Log> parse_libinput_record(std::istream& in, std::string_view name);

// Reads a recording of a pen by evemu-record, versions 1.0 to 1.3: the kernel's input events, which
// become reports of a HID pen (drivers/reports/event_pen.h). Fails with a user error if the device
// is not a pen.
Result<Log> parse_evemu(std::istream& in, std::string_view name);

// True if the line begins an evemu recording, and not a hid-recorder file.
bool begins_evemu_recording(std::string_view line);

enum class LogFormat {
    TractusLog, // Includes hid-recorder files, since our format extends theirs.
    UsbhidDump,
    LibinputRecord,
    Evemu,
};

// Guesses the format from the first lines of a text, or of a regular file. No value if no line
// identifies a format, or if the file cannot be read.
std::optional<LogFormat> guess_log_format(std::string_view text);
std::optional<LogFormat> guess_file_format(std::filesystem::path const& path);

} // namespace tractus::drivers
