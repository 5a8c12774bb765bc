#pragma once

#include "drivers/logs/log.h"

#include <cstddef>
#include <span>
#include <string>

namespace tractus::drivers {

// Puts what another program has recorded together as a log.
class ForeignLogBuilder {
public:
    explicit ForeignLogBuilder(std::string_view name) { log_.name = name; }

    Log& log() { return log_; }

    // Counts something odd in a line.
    void warn(std::size_t line, std::string message);

    // Skips, with a warning, what no device sends. Fails, as the user's fault, if more has come
    // than there is memory for.
    Result<void> append_report(std::size_t line, std::size_t device, Timestamp time,
                               std::span<std::byte const> bytes);

    // Adds another device and returns its index. Fails, as the user's fault, for more than a
    // computer has.
    Result<std::size_t> add_device(DeviceInfo info);

    // Takes a device and its reports away; the indices of those behind it go down by one.
    void remove_device(std::size_t device);

    // The log, with its first report at 0. Reports of several devices, which some programs write
    // one device after another, stand in the order of their times; those of one device as they
    // came.
    Log take();

private:
    void sort_by_time();

    Log log_;
};

} // namespace tractus::drivers
