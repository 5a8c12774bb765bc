#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Contents of the top of a log.
struct LogHeader {
    std::vector<DeviceInfo> devices {};
    std::string rig_text {}; // The rig's calibration, any text; empty for none.
    Timestamp start {};      // Times in the log count from here; earlier ones become 0.
};

// Writes a log (see drivers/log.h) that hid-replay can play as well: report by report, so that
// what was written is of use even if the program does not come to its end.
//
// The stream must outlive the writer. Not thread-safe. What the stream could not take is told by
// flush().
class LogWriter {
public:
    LogWriter(std::ostream& out, LogHeader const& header);

    // `device` is an index in LogHeader::devices. Times are cut to microseconds. No bytes: the
    // device went away.
    void write_report(std::size_t device, Timestamp time, std::span<std::byte const> bytes);

    // `tool` is one word, `arguments` the rest of its line.
    void write_tool(Timestamp time, std::string_view tool, std::string_view arguments = {});

    // Hands everything to the operating system. Fails, as the user's fault, if the disk is full.
    Result<void> flush();

private:
    void append_device(std::size_t index, DeviceInfo const&);
    void append_time(char letter, Timestamp);
    void append_bytes(std::span<std::byte const>);
    void write_line();

    std::ostream& out_;
    Timestamp start_;
    std::size_t device_count_;
    std::size_t current_device_ = 0; // The one that the last D line names.
    std::string line_;               // The line that write_line() sends next; kept for its memory.
};

} // namespace tractus::drivers
