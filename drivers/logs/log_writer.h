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

// Content of a log's header.
struct LogHeader {
    std::vector<DeviceInfo> devices {};
    std::string rig_text {}; // The rig's calibration, as any text; empty if there is none.
    Timestamp start {};      // Time that becomes 0 in the log; earlier times become 0, too.
};

// Writes a log (see drivers/logs/log.h) that hid-replay can also play. Each report is written at
// once, so a log remains useful even if the program crashes.
//
// The stream must outlive the writer. Not thread-safe. Errors of the stream are returned by
// flush().
class LogWriter {
public:
    LogWriter(std::ostream& out, LogHeader const& header);

    // Writes one report. `device` is an index in LogHeader::devices; times are truncated to
    // microseconds. Empty `bytes` mean that the device was disconnected.
    void write_report(std::size_t device, Timestamp time, std::span<std::byte const> bytes);

    // Writes a change of tool: `tool` is one word, `arguments` is the rest of the line.
    void write_tool(Timestamp time, std::string_view tool, std::string_view arguments = {});

    // Flushes the stream to the operating system. Fails with a user error if the disk is full.
    Result<void> flush();

private:
    void append_device(std::size_t index, DeviceInfo const&);
    void append_time(char letter, Timestamp);
    void append_bytes(std::span<std::byte const>);
    void write_line();

    std::ostream& out_;
    Timestamp start_;
    std::size_t device_count_;
    std::size_t current_device_ = 0; // Device index of the last D line written.
    std::string line_;               // Buffer for the line that write_line() writes next.
};

} // namespace tractus::drivers
