#include "drivers/logs/log_source.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus::drivers {

LogSource::LogSource(Log const& log, std::size_t device)
    : log_(log)
    , device_(device)
    , cursor_(log)
{
    CHECK(device < log.devices.size());
}

Result<std::optional<RawReport>> LogSource::read(Duration)
{
    while (auto const* const from = TRY(cursor_.next())) {
        if (from->device != device_)
            continue;
        RawReport report { .received = from->time, .size = from->bytes.size() };
        std::ranges::copy(from->bytes, report.storage.begin());
        return std::optional(report);
    }
    return std::optional<RawReport>();
}

} // namespace tractus::drivers
