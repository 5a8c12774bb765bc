#pragma once

#include "drivers/logs/line_splitter.h"
#include "drivers/logs/log.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Facts about a device number of a log.
struct LogDeviceNumber {
    std::size_t number = 0;
    bool has_descriptor = false;
    // True if the device has reported in this part of the log and has not been disconnected since.
    bool is_there = false;
};

// A position at a line's start in a log's text, and the state with which reading can continue
// there.
struct LogPlace {
    std::uint64_t offset = 0;
    std::size_t line = 0;                     // Number of lines before this position.
    std::vector<LogDeviceNumber> numbered {}; // Device numbers, parallel to Log::devices.
    std::size_t number = 0;                   // Device number of the last D line.
    // Index of the current device; no value until a line describes it.
    std::optional<std::size_t> device {};
    Duration shift {};           // Added to times in the file to give the times of records.
    bool has_second_rig = false; // True after the warning about a second calibration.
    // Time, as written in the file, of the latest record of the recording that is being read. A
    // file may contain several recordings.
    std::optional<Timestamp> latest {};
};

// Totals over all records of a log.
struct LogTotals {
    std::size_t count = 0;
    Timestamp begin {}; // Time of the first record.
    Timestamp end {};   // Time of the last record.
};

// Reads a log's text, which arrives piece by piece. parse_log() documents what is tolerated and
// refused.
class LogText {
public:
    // Once the records in memory exceed `most_bytes`, later records are only counted.
    explicit LogText(std::string_view name,
                     std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

    // Continues at `place`. The log then contains only the records from there on.
    LogText(std::string_view name, LogPlace place);

    LogText(LogText const&) = delete;
    LogText& operator=(LogText const&) = delete;

    // Reserves memory for a text of at most `bytes`.
    void expect(std::size_t bytes);

    // Adds the next piece of the text, which may end anywhere. Fails with a user error for what
    // parse_log() refuses.
    Result<void> feed(std::string_view piece);

    // Ends the text: a last line without a line break is used if it is complete. Fails like feed().
    Result<void> end();

    // Returns the log, after end(). Fails if no device was described.
    Result<Log> take_log();

    // The records read since the last forget_records(), and their bytes.
    Log const& log() const { return log_; }
    void forget_records();

    LogTotals const& totals() const { return totals_; }

    // Position in the file of the first record that is not in memory; no value if all are.
    std::optional<LogPlace> const& rest() const { return rest_; }

private:
    Result<void> take_line(std::string_view line);
    Result<void> read_line(std::string_view line);
    Result<void> read_described_line(char kind, std::string_view content);
    Result<void> read_report(std::string_view content);
    Result<void> read_departure(std::string_view content);
    Result<void> read_descriptor(std::string_view content);
    void read_device_number(std::string_view content);
    void read_ids(std::string_view content);
    void read_size(std::string_view content);
    void read_string(std::string_view content);
    void read_tool(std::string_view content);
    void read_rig_line(std::string_view content);
    Result<void> check_described() const;
    void take_record(Timestamp time, std::size_t offset);
    void add_record(Timestamp time, std::size_t device, std::size_t offset);
    void begin_part(Timestamp time);
    void move_last_tools(Timestamp time, Duration shift, std::size_t count_before);
    DeviceInfo& device();
    void warn(std::string message);
    tl::unexpected<Error> broken(std::string const& what) const;

    Log log_;
    std::size_t most_bytes_;
    LineSplitter lines_;
    LogPlace place_; // Position of the line being read.
    std::optional<LogPlace> rest_;
    LogTotals totals_;
    std::size_t described_bytes_
        = 0;               // Total length of the lines that are neither reports nor disconnections.
    bool is_begin_ = true; // True until the first text arrives.
    bool is_whole_ = true; // True if the line being read ends with a line break.
};

// Reads the log in a regular file; see read_log().
Result<Log> read_log_file(std::filesystem::path const& path);

} // namespace tractus::drivers
