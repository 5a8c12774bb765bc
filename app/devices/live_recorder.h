#pragma once

#include "app/devices/live_devices.h"
#include "drivers/logs/log_writer.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string_view>
#include <vector>

namespace tractus::devices {

// Fails with a user error if a file of this name exists. A recording is never overwritten, as it
// cannot be repeated.
Result<void> check_new_file(std::filesystem::path const& path);

// Writes all reports of live devices to a log at once. If the program crashes, at most the reports
// of the last kFlushEvery are lost, but no finished stroke.
class LiveRecorder {
public:
    static constexpr Duration kFlushEvery = std::chrono::milliseconds(250);

    // Creates a new log file. Fails like check_new_file(), or if the file cannot be written.
    static Result<LiveRecorder> create(std::filesystem::path const& path,
                                       drivers::LogHeader const& header);

    // Starts a log in the given stream.
    LiveRecorder(std::unique_ptr<std::ostream> out, drivers::LogHeader const& header);

    void write(LiveReport const& report);
    void write_tool(Timestamp time, std::string_view tool, std::string_view arguments);

    // Flushes the log to the operating system if a stroke has ended, or if kFlushEvery has passed
    // since the last flush. Fails with a user error if the disk is full.
    Result<void> flush_if_due(Timestamp now);
    Result<void> flush();

    std::size_t report_count() const { return report_count_; }
    std::uint64_t byte_count() const { return byte_count_; } // Size of the log at the last flush.

private:
    bool ends_stroke(LiveReport const& report);

    struct Pen {
        std::unique_ptr<drivers::PenDecoder> decoder; // Null if the device is not a pen.
        bool touching = false;
    };

    // On the heap, as log_ keeps a reference to the stream when this object moves.
    std::unique_ptr<std::ostream> out_;
    std::unique_ptr<drivers::LogWriter> log_;
    std::vector<Pen> pens_; // One element per device.
    // Samples of the current report. A member, so that its memory is reused.
    std::vector<drivers::PenSample> samples_;
    bool stroke_ended_ = false;
    Timestamp next_flush_ {};
    std::size_t report_count_ = 0;
    std::uint64_t byte_count_ = 0;
};

} // namespace tractus::devices
