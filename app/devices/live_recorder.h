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

// Checks that no file has this name. Fails with a user error if one exists: a recording cannot be
// repeated, so it is never overwritten.
Result<void> check_new_file(std::filesystem::path const& path);

// Writes what live devices send to a log immediately. If the program crashes, at most the last
// kFlushEvery is lost, and no finished stroke.
class LiveRecorder {
public:
    static constexpr Duration kFlushEvery = std::chrono::milliseconds(250);

    // Creates a new file. Fails like check_new_file(), or if it cannot be written.
    static Result<LiveRecorder> create(std::filesystem::path const& path,
                                       drivers::LogHeader const& header);

    // Starts a log in a stream.
    LiveRecorder(std::unique_ptr<std::ostream> out, drivers::LogHeader const& header);

    void write(LiveReport const& report);
    void write_tool(Timestamp time, std::string_view tool, std::string_view arguments);

    // Flushes to the operating system if kFlushEvery has passed since the last flush or a stroke
    // has ended. Fails with a user error if the disk is full.
    Result<void> flush_if_due(Timestamp now);
    Result<void> flush();

    std::size_t report_count() const { return report_count_; }
    std::uint64_t byte_count() const { return byte_count_; } // Bytes up to the last flush.

private:
    bool ends_stroke(LiveReport const& report);

    struct Pen {
        std::unique_ptr<drivers::PenDecoder> decoder; // Null if the device is not a pen.
        bool touching = false;
    };

    std::unique_ptr<std::ostream> out_; // On the heap, as log_ refers to it when this object moves.
    std::unique_ptr<drivers::LogWriter> log_;
    std::vector<Pen> pens_;                   // Pens among the devices, one entry per device.
    std::vector<drivers::PenSample> samples_; // Kept as a member so that its memory is reused.
    bool stroke_ended_ = false;
    Timestamp next_flush_ {};
    std::size_t report_count_ = 0;
    std::uint64_t byte_count_ = 0;
};

} // namespace tractus::devices
