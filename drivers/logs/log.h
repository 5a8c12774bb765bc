#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// A device log in memory: the devices, every report with its time, and the station's own entries.
// The first letter of a line is its kind; lines with unknown letters are skipped:
//
//   # text                        a comment
//   D: 1                          device number of the lines below; 0 before the first D line
//   R: 4 05 0d 09 02              the device's report descriptor: its length, then its bytes
//   N: Wacom CTL-472              its name
//   P: usb-0000:00:14.0-1/input0  the kernel's path to it
//   I: 3 056a 037a                bus, vendor and product id, hexadecimal
//   M: Wacom Co.,Ltd.             its manufacturer (ours, as are the next three)
//   U: 8JQ01                      its serial number
//   A: 203 127                    its active area in mm, as the kernel's driver reports it (ours)
//   S: 201 HUION_T153_130524      one of its USB string descriptors: index, text
//   E: 000001.250000 3 02 80 10   a report: seconds since the start, its length, then its bytes
//   G: 000002.500000              the device was disconnected: seconds (ours)
//   C: max_travel_mm = 400        a line of the rig's calibration, opaque here (ours)
//   T: 000001.250000 draw trunk   a change of tool: seconds, its name, its arguments (ours)
//
// Without the lines marked "ours" this is the hid-recorder format, so any hid-recorder file is a
// log, and other programs skip our lines. parse_log() lists the deviations that it tolerates. In M,
// U and S lines, backslashes, control characters, and blanks at either end are written as "\xHH".

// One report. Its bytes are in Log::bytes.
struct LogRecord {
    Timestamp time {};        // Time since the start of the recording.
    std::uint32_t offset = 0; // Offset of the report's bytes in Log::bytes.
    std::uint16_t size = 0;   // Size in bytes. 0 means that the device was disconnected.
    std::uint16_t device = 0; // Index of the device in Log::devices.

    bool operator==(LogRecord const&) const = default;
};

// A change of tool: strokes drawn from this time on belong to another tool.
struct LogTool {
    Timestamp time {};
    std::string tool {};      // One word: "select", "draw", "indicate", …
    std::string arguments {}; // The rest of the line, interpreted by the tool.
    std::size_t position = 0; // Number of records that precede it in the file.
};

// An oddity in a log that did not prevent reading it.
struct LogWarning {
    std::size_t line = 0; // Line number, from 1.
    std::string message {};
};

struct LogRemainder; // Location of the reports that are not in memory.

// A log. Only the first reports of a large file are in memory; read all of them with a LogCursor.
struct Log {
    std::string name; // The file's name, for messages.
    std::vector<DeviceInfo> devices;
    // Records in the file's order; of a large file, only the first ones.
    std::vector<LogRecord> records;
    std::vector<std::byte> bytes;             // The bytes of all records, one after another.
    std::shared_ptr<LogRemainder const> rest; // Null if all reports are in memory.
    std::vector<LogTool> tools;               // Tools in the file's order.
    // The file's C lines, each ended by a line break; empty if there are none.
    std::string rig_text;
    std::vector<LogWarning> warnings; // The first kMaxLogWarnings warnings.
    std::size_t warning_count = 0;    // Number of all warnings, including those that were not kept.

    // Returns the number of all records, in memory or not.
    std::size_t record_count() const;
    bool empty() const { return records.empty(); }
    Timestamp begin() const; // Time of the first record; 0 in an empty log.
    Timestamp end() const;   // Time of the last record; 0 in an empty log.

    std::span<std::byte const> report(LogRecord const& record) const
    {
        return std::span(bytes).subspan(record.offset, record.size);
    }
};

constexpr std::size_t kMaxLogWarnings = 20;

// A report or a disconnection, as returned by a LogCursor.
struct LogReport {
    Timestamp time {};
    std::size_t device = 0;              // Index of the device in Log::devices.
    std::span<std::byte const> bytes {}; // Empty if the device was disconnected.
};

// Iterates over a log's reports in the file's order, with only a piece of the file in memory.
// Several cursors may read a log at the same time, each in its own thread. The log must outlive its
// cursors.
class LogCursor {
public:
    explicit LogCursor(Log const& log);
    LogCursor(LogCursor&&) noexcept;
    LogCursor& operator=(LogCursor&&) noexcept;
    ~LogCursor();

    // Returns the next report without advancing; null after the last one. The pointer is valid
    // until skip(). Fails with a user error if the file cannot be read again, or now contains a
    // different number of reports.
    Result<LogReport const*> peek();
    void skip();

    // Returns the next report and advances; the pointer is valid until the next call. Fails like
    // peek().
    Result<LogReport const*> next();

    // Number of reports that skip() or next() has passed.
    std::size_t position() const { return position_; }

private:
    class Rest;

    Log const* log_;
    std::size_t position_ = 0;
    LogReport report_ {};
    std::unique_ptr<Rest> rest_; // Set when all reports in memory have been returned.
};

// Parses a log in memory; `name` identifies it in messages.
//
// Tolerates: "D:0" without a blank, device numbers with gaps, ids in either case and unpadded,
// times with fewer or more than six decimals, blank lines, unknown letters, CR LF line ends. Times
// may go back, as in recordings that were concatenated or continued after a restart. A step back by
// more than 0.1 s begins another part: all devices are disconnected at the end of the previous
// part, the times of the new part continue 0.2 s later, and a warning says so. The calibration of a
// later part is skipped. Skips with a warning: reports longer than 512 bytes or with another number
// of bytes than they announce, an incomplete last line, a second, different descriptor of the same
// device. Fails with a user error with file and line: a text without any R line, an R line
// whose length is not the number of its bytes, a report of a device without an R line, a line of
// more than 1 MiB, an implausible number of rig lines or changes of tool, text in UTF-16.
Result<Log> parse_log(std::string_view text, std::string_view name);

// Reads a log file of any size, piece by piece. Only one line of text and the first kMaxLogBytes of
// reports are kept in memory. A pipe, which cannot be read twice, may contain no more than
// kMaxPipedLogBytes of reports.
Result<Log> read_log(std::filesystem::path const& path);

// Limits of the memory for reports; each report takes sizeof(LogRecord) and its own bytes.
constexpr std::size_t kMaxLogBytes = std::size_t { 1 } << 20;
constexpr std::size_t kMaxPipedLogBytes = std::size_t { 32 } << 20;

// Returns the warnings as one line for the user: "FILE: 2 odd lines, the first is line 7: …". Empty
// if there are none.
std::string summarize_warnings(Log const&);

} // namespace tractus::drivers
