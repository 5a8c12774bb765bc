#pragma once

#include "drivers/logs/log.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus::drivers {

// Assembles a log from the recording of another program.
class ForeignLogBuilder {
public:
    explicit ForeignLogBuilder(std::string_view name) { log_.name = name; }

    Log& log() { return log_; }

    // Adds a warning about something odd in the recording's line number `line`.
    void warn(std::size_t line, std::string message);

    // Appends a report. A report that no device could have sent is skipped with a warning. Fails
    // with a user error if the recording exceeds the memory limit.
    Result<void> append_report(std::size_t line, std::size_t device, Timestamp time,
                               std::span<std::byte const> bytes);

    // Adds a device and returns its index. Fails with a user error beyond the number of devices
    // that a computer can have.
    Result<std::size_t> add_device(DeviceInfo info);

    // Removes a device and its reports; the indices of later devices decrease by one.
    void remove_device(std::size_t device);

    // Returns the log, with its first report at time 0. Reports of different devices, which some
    // programs write one device after another, are sorted by time; reports of one device keep their
    // order.
    Log take();

private:
    void sort_by_time();

    Log log_;
};

} // namespace tractus::drivers
