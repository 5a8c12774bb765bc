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

    // The log, with its first report at 0.
    Log take();

private:
    Log log_;
};

} // namespace tractus::drivers
