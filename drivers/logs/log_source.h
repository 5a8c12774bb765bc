#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"

#include <cstddef>

namespace tractus::drivers {

// A source that gives the reports of one device of a log, with their recorded times. It never
// waits, and returns no value after the log's end. The log must outlive it.
class LogSource final : public ReportSource {
public:
    // `device` is an index in Log::devices.
    LogSource(Log const& log, std::size_t device);

    DeviceInfo const& info() const override { return log_.devices[device_]; }

    // Returns the device's next report. Fails like LogCursor.
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    Log const& log_;
    std::size_t device_;
    LogCursor cursor_;
};

} // namespace tractus::drivers
