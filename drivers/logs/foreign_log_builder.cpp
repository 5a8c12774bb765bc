#include "drivers/logs/foreign_log_builder.h"

#include "drivers/reports/report_source.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

void ForeignLogBuilder::warn(std::size_t line, std::string message)
{
    if (log_.warning_count++ < kMaxLogWarnings)
        log_.warnings.push_back({ line, std::move(message) });
}

Result<void> ForeignLogBuilder::append_report(std::size_t line, std::size_t device, Timestamp time,
                                              std::span<std::byte const> bytes)
{
    constexpr std::size_t kMaxReportBytes = sizeof(RawReport::storage);
    if (bytes.empty() || bytes.size() > kMaxReportBytes) {
        warn(line,
             fmt::format("a report of {} bytes, which is not in 1 to {}: skipped", bytes.size(),
                         kMaxReportBytes));
        return {};
    }
    if (log_.records.size() * sizeof(LogRecord) + log_.bytes.size() > kMostPipedLogBytes)
        return fail(Fault::User,
                    fmt::format("{} holds more reports than are read at once: cut it into parts",
                                log_.name));
    log_.records.push_back({ .time = time,
                             .offset = static_cast<std::uint32_t>(log_.bytes.size()),
                             .size = static_cast<std::uint16_t>(bytes.size()),
                             .device = static_cast<std::uint16_t>(device) });
    log_.bytes.insert(log_.bytes.end(), bytes.begin(), bytes.end());
    return {};
}

Result<std::size_t> ForeignLogBuilder::add_device(DeviceInfo info)
{
    constexpr std::size_t kMaxDevices = 1024;
    if (log_.devices.size() == kMaxDevices)
        return fail(Fault::User,
                    fmt::format("{} names more than {} devices: this is no recording", log_.name,
                                kMaxDevices));
    log_.devices.push_back(std::move(info));
    return log_.devices.size() - 1;
}

Log ForeignLogBuilder::take()
{
    auto const first
        = std::min_element(log_.records.begin(), log_.records.end(),
                           [](auto const& a, auto const& b) { return a.time < b.time; });
    if (first != log_.records.end()) {
        auto const begin = first->time.time_since_epoch();
        for (auto& record : log_.records)
            record.time -= begin;
    }
    return std::move(log_);
}

} // namespace tractus::drivers
