#pragma once

#include "drivers/logs/log.h"
#include "engine/base/result.h"

#include <filesystem>
#include <istream>
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

// The HID part of what `libinput record --with-hidraw` writes (YAML): the report descriptor of each
// device ("hid") and the raw reports among its events. Input events are skipped: they are what the
// kernel made of the reports. Fails, as the user's fault, if it is not YAML, or if no device has
// raw reports.
Result<Log> parse_libinput_record(std::istream& in, std::string_view name);

enum class LogFormat {
    TractusLog, // Hid-recorder's too, of which it is a superset.
    UsbhidDump,
    LibinputRecord,
};

// Tells from the first lines; what is neither of the others counts as a log of ours.
LogFormat guess_log_format(std::string_view text);

// A recording in any of the formats. Fails like the reader of its format.
Result<Log> read_any_log(std::filesystem::path const& path);

} // namespace tractus::drivers
