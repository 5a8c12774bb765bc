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
    bool is_there = false; // It has reported in this part of the log, and not gone away since.
};

// Where a line begins in a log's text, and what the lines before it said that matters to those from
// there on.
struct LogPlace {
    std::uint64_t offset = 0;
    std::size_t line = 0;                     // How many come before.
    std::vector<LogDeviceNumber> numbered {}; // Beside Log::devices.
    std::size_t number = 0;                   // As the last D line says.
    std::optional<std::size_t> device {};     // Its index; none until something is said of it.
    Duration shift {};                        // From the file's times to those of the records.
    bool has_second_rig = false;              // It has been warned of.
    std::optional<Timestamp> latest {};       // Time in the file of the latest record of this part.
};

// Totals over all records of a log.
struct LogTotals {
    std::size_t count = 0;
    Timestamp begin {}; // Time of the first and
    Timestamp end {};   // of the last one.
};

// Reads a log's text, which comes piece by piece. What it tolerates and refuses is parse_log()'s.
class LogText {
public:
    // Where the records in memory have so many bytes, those that follow are only counted.
    explicit LogText(std::string_view name,
                     std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

    // Reads on from there, with no more of the log than the records that come.
    LogText(std::string_view name, LogPlace place);

    LogText(LogText const&) = delete;
    LogText& operator=(LogText const&) = delete;

    // Announces at most that many bytes.
    void expect(std::size_t bytes);

    // The next piece of the text, cut anywhere. Fails, as the user's fault, for what parse_log()
    // refuses.
    Result<void> feed(std::string_view piece);

    // The text has ended: a last line without a line break counts as far as it is whole. Fails
    // likewise.
    Result<void> end();

    // Returns the log, after end(). Fails if no device was described.
    Result<Log> take_log();

    // The records that came since the last forget_records(), and their bytes.
    Log const& log() const { return log_; }
    void forget_records();

    LogTotals const& totals() const { return totals_; }

    // Where the records begin that are not in memory; no value where all are.
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
    LogPlace place_; // Place of the line that is read.
    std::optional<LogPlace> rest_;
    LogTotals totals_;
    std::size_t described_bytes_ = 0; // Bytes of lines that are neither reports nor departures.
    bool is_begin_ = true;            // Nothing has come.
    bool is_whole_ = true;            // Does the line end with a line break?
};

// Reads the log in a regular file, as read_log() does.
Result<Log> read_log_file(std::filesystem::path const& path);

} // namespace tractus::drivers
