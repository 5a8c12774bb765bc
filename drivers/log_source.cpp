#include "drivers/log_source.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus {

LogSource::LogSource(Log const& log, std::size_t device)
    : log_(log)
    , device_(device)
{
    CHECK(device < log.devices.size());
}

Result<std::optional<RawReport>> LogSource::read(Duration)
{
    while (next_ < log_.records.size()) {
        auto const& record = log_.records[next_++];
        if (record.device != device_)
            continue;
        RawReport report { .received = record.time, .size = record.size };
        std::ranges::copy(log_.report(record), report.storage.begin());
        return std::optional(report);
    }
    return std::optional<RawReport>();
}

} // namespace tractus
