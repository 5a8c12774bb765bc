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

// Fails, as the user's fault, if the file is there already: a recording cannot be made again, so it
// is never written over.
Result<void> check_new_file(std::filesystem::path const& path);

// Writes what live devices send to a log while it comes, so that whatever happens to the program,
// little is lost: less than kFlushEvery before its end, and no finished stroke.
class LiveRecorder {
public:
    static constexpr Duration kFlushEvery = std::chrono::milliseconds(250);

    // Begins a new file. Fails like check_new_file, or if it cannot be written.
    static Result<LiveRecorder> create(std::filesystem::path const& path,
                                       drivers::LogHeader const& header);

    // Begins a log in a stream.
    LiveRecorder(std::unique_ptr<std::ostream> out, drivers::LogHeader const& header);

    void write(LiveReport const& report);
    void write_tool(Timestamp time, std::string_view tool, std::string_view arguments);

    // Hands what was written to the system if kFlushEvery has passed since it last did or a stroke
    // has ended. Fails, as the user's fault, if the disk is full.
    Result<void> flush_if_due(Timestamp now);
    Result<void> flush();

    std::size_t report_count() const { return report_count_; }
    std::uint64_t byte_count() const { return byte_count_; } // Bytes up to the last flush.

private:
    bool ends_stroke(LiveReport const& report);

    struct Pen {
        std::unique_ptr<drivers::PenDecoder> decoder; // Null for what is no pen.
        bool touching = false;
    };

    std::unique_ptr<std::ostream> out_; // On the heap, since log_ refers to it when this moves.
    std::unique_ptr<drivers::LogWriter> log_;
    std::vector<Pen> pens_;                   // One per device.
    std::vector<drivers::PenSample> samples_; // Kept for its memory.
    bool stroke_ended_ = false;
    Timestamp next_flush_ {};
    std::size_t report_count_ = 0;
    std::uint64_t byte_count_ = 0;
};

} // namespace tractus::devices
