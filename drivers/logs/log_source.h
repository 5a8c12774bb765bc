#pragma once

#include "drivers/logs/log.h"
#include "drivers/reports/report_source.h"

#include <cstddef>

namespace tractus::drivers {

// One device of a log as a source: its reports with the log's times, as fast as they are read.
// It never waits, and gives no value from the log's end on. The log must outlive it.
class LogSource final : public ReportSource {
public:
    // `device` is an index in Log::devices.
    LogSource(Log const& log, std::size_t device);

    DeviceInfo const& info() const override { return log_.devices[device_]; }

    // Fails like LogCursor.
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    Log const& log_;
    std::size_t device_;
    LogCursor cursor_;
};

} // namespace tractus::drivers
