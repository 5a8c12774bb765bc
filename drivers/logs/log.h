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

// A device log as values: what was plugged in, every report with its time, and what the station
// added. The format, line by line, where the first letter decides and unknown letters are skipped:
//
//   # text                        a comment
//   D: 1                          the lines below are about device 1; 0 before the first such line
//   R: 4 05 0d 09 02              that device's report descriptor: its length, then its bytes
//   N: Wacom CTL-472              its name
//   P: usb-0000:00:14.0-1/input0  the kernel's path to it
//   I: 3 056a 037a                bus, vendor and product id, hexadecimal
//   M: Wacom Co.,Ltd.             its manufacturer (ours, as are the next three)
//   U: 8JQ01                      its serial number
//   A: 203 127                    its active area in mm, as the kernel's driver knows it (ours)
//   S: 201 HUION_T153_130524      one of its USB string descriptors: index, text
//   E: 000001.250000 3 02 80 10   a report: seconds since the start, its length, then its bytes
//   G: 000002.500000              the device went away: seconds (ours)
//   C: max_travel_mm = 400        a line of the rig's calibration, opaque here (ours)
//   T: 000001.250000 draw trunk   a change of tool: seconds, its name, what it needs (ours)
//
// A log without our lines is in the hid-recorder format, so anybody's recording is a log, and other
// readers skip our lines. See parse_log for the liberties that files in the wild take. In M, U and
// S lines a backslash, a control character and a blank at either end are written "\xHH".

// One report. Its bytes lie in Log::bytes.
struct LogRecord {
    Timestamp time {};        // Since the start of the recording.
    std::uint32_t offset = 0; // Offset in Log::bytes.
    std::uint16_t size = 0;   // 0: not a report, the device went away.
    std::uint16_t device = 0; // Index in Log::devices.

    bool operator==(LogRecord const&) const = default;
};

// "From now on the pen means this."
struct LogTool {
    Timestamp time {};
    std::string tool {};      // "select", "draw", "indicate", …: one word.
    std::string arguments {}; // The rest of the line; the tool knows what it means.
    std::size_t position = 0; // How many records come before it in the file.
};

// Something odd in a log that did not keep it from being read.
struct LogWarning {
    std::size_t line = 0; // Line number, from 1.
    std::string message {};
};

struct LogRest; // Where the reports are that are not in memory.

// A log. Of a large file, only the first reports are in memory: read them with a LogCursor.
struct Log {
    std::string name; // The file's name, for messages.
    std::vector<DeviceInfo> devices;
    std::vector<LogRecord> records;      // In the file's order; the first of them in a large file.
    std::vector<std::byte> bytes;        // Their bytes, one after another.
    std::shared_ptr<LogRest const> rest; // Null where all are in memory.
    std::vector<LogTool> tools;          // Tools in the file's order.
    std::string rig_text;                // The C lines, each ended by a line break; empty if none.
    std::vector<LogWarning> warnings;    // The first kMaxLogWarnings of them.
    std::size_t warning_count = 0;       // Number of all of them.

    // Number of all records, in memory or not.
    std::size_t record_count() const;
    bool empty() const { return records.empty(); }
    Timestamp begin() const; // The time of the first one; 0 if there is none.
    Timestamp end() const;   // The time of the last one; 0 if there is none.

    std::span<std::byte const> report(LogRecord const& record) const
    {
        return std::span(bytes).subspan(record.offset, record.size);
    }
};

constexpr std::size_t kMaxLogWarnings = 20;

// One report, or a departure, as a LogCursor gives it.
struct LogReport {
    Timestamp time {};
    std::size_t device = 0;              // Index in Log::devices.
    std::span<std::byte const> bytes {}; // Empty: the device went away.
};

// Gives a log's reports one after another, in the file's order, with no more than a piece of the
// file in memory. Any number of them may read a log at the same time, each in one thread. The log
// must outlive it.
class LogCursor {
public:
    explicit LogCursor(Log const& log);
    LogCursor(LogCursor&&) noexcept;
    LogCursor& operator=(LogCursor&&) noexcept;
    ~LogCursor();

    // The report that is next, again until skip(). Valid until then; null after the last one.
    // Fails, as the user's fault, if the file cannot be read again, or has another
    // number of reports now.
    Result<LogReport const*> peek();
    void skip();

    // Does both in one: the report is valid until the next call. Fails like peek().
    Result<LogReport const*> next();

    // How many were skipped or given by next().
    std::size_t position() const { return position_; }

private:
    class Rest;

    Log const* log_;
    std::size_t position_ = 0;
    LogReport report_ {};
    std::unique_ptr<Rest> rest_; // Once the reports in memory have been given.
};

// Reads a log from text at hand; `name` is what messages call it.
//
// Tolerates: "D:0" without a blank, device numbers with gaps, ids in any case and unpadded, times
// with fewer or more than six digits after the point, blank lines, unknown letters, CR LF ends.
// Times may go back, in recordings that were joined or went on after a restart. By more than 0.1 s
// that begins another part: all devices go away at the end of the part before, the times of the
// next one count on from 0.2 s later, and a warning says so. Its calibration is skipped.
// Skips with a warning: reports that do not have the bytes they announce or more than 512, a last
// line without its line break that is not whole, a second, different descriptor of the same device.
// Fails, as the user's fault, with file and line: a text without any R line, an R line whose length
// is not the number of its bytes, a report of a device without R line, a line of more than 1 MiB,
// more rig lines or changes of tool than anybody makes, text in UTF-16.
Result<Log> parse_log(std::string_view text, std::string_view name);

// Reads the log in a file of any size, piece by piece: of the text no more than a line is kept, and
// of the reports the first kMostLogBytes. A pipe, which cannot be read again, may have no more than
// kMostPipedLogBytes of them.
Result<Log> read_log(std::filesystem::path const& path);

// Limits of what is in memory: a report takes sizeof(LogRecord) and its own bytes.
constexpr std::size_t kMostLogBytes = std::size_t { 1 } << 20;
constexpr std::size_t kMostPipedLogBytes = std::size_t { 32 } << 20;

// The warnings in one line for a person: "FILE: 2 odd lines, the first is line 7: …", or empty.
std::string summarize_warnings(Log const&);

} // namespace tractus::drivers
