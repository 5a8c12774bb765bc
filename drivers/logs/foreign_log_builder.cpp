#include "drivers/logs/foreign_log_builder.h"

#include "drivers/reports/report_source.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>
#include <vector>

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
    if (log_.records.size() * sizeof(LogRecord) + log_.bytes.size() > kMaxPipedLogBytes)
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

void ForeignLogBuilder::remove_device(std::size_t device)
{
    log_.devices.erase(log_.devices.begin() + static_cast<std::ptrdiff_t>(device));
    std::erase_if(log_.records, [&](auto const& record) { return record.device == device; });
    for (auto& record : log_.records)
        if (record.device > device)
            --record.device;
}

// Sorts the records by time. A report whose time goes back keeps its place after the earlier
// reports of its device.
void ForeignLogBuilder::sort_by_time()
{
    std::vector<Timestamp> latest(log_.devices.size(), Timestamp::min());
    std::vector<std::pair<Timestamp, LogRecord>> places;
    places.reserve(log_.records.size());
    for (auto const& record : log_.records) {
        auto& time = latest[record.device];
        time = std::max(time, record.time);
        places.emplace_back(time, record);
    }
    auto const is_earlier = [](auto const& a, auto const& b) { return a.first < b.first; };
    if (std::is_sorted(places.begin(), places.end(), is_earlier))
        return;
    std::stable_sort(places.begin(), places.end(), is_earlier);
    std::transform(places.begin(), places.end(), log_.records.begin(),
                   [](auto const& place) { return place.second; });
}

Log ForeignLogBuilder::take()
{
    if (log_.devices.size() > 1)
        sort_by_time();
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
