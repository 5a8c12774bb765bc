#include "app/devices/watch_view.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::devices {

namespace {

constexpr std::size_t kBytesPerLine = 16;
constexpr std::size_t kBytesWidth = 3 * kBytesPerLine + 2;

double milliseconds(Duration duration)
{
    return to_seconds(duration) * 1e3;
}

// Appends the bytes of the newest report, sixteen per line, beside the fields of its sample.
void append_report(diagnosis::DeviceReading const& reading, std::vector<std::string>& lines)
{
    auto const bytes = reading.last ? reading.last->bytes() : std::span<std::byte const> {};
    auto const byte_lines = (bytes.size() + kBytesPerLine - 1) / kBytesPerLine;
    for (std::size_t i = 0; i < std::max(byte_lines, reading.fields.size()); ++i) {
        std::string text;
        auto const first = std::min(i * kBytesPerLine, bytes.size());
        for (auto const byte : bytes.subspan(first, std::min(kBytesPerLine, bytes.size() - first)))
            text += fmt::format("{:02x} ", std::to_integer<unsigned>(byte));
        if (i < reading.fields.size())
            text = fmt::format("{:<{}}{:<9} {}", text, kBytesWidth, reading.fields[i].first,
                               reading.fields[i].second);
        lines.push_back("  " + text);
    }
}

} // namespace

std::string describe_pace(diagnosis::DeviceReading const& reading)
{
    auto const& pace = reading.pace;
    if (reading.is_away)
        return fmt::format("gone; waiting for it to come back; {} reports", reading.reports);
    if (pace.rate_hz == 0)
        return fmt::format("nothing now; {} reports", reading.reports);
    return fmt::format("{:.1f}/s  every {:.2f} ms  jitter {:.2f} ms  longest {:.2f} ms  {} "
                       "reports  {} broken",
                       pace.rate_hz, milliseconds(pace.mean_interval), milliseconds(pace.jitter),
                       milliseconds(pace.longest_interval), reading.reports,
                       reading.broken_reports);
}

std::vector<std::string> watch_lines(std::span<diagnosis::DeviceReading const> readings,
                                     std::size_t width)
{
    std::vector<std::string> lines;
    for (auto const& reading : readings) {
        lines.push_back(fmt::format("{} ({:04x}:{:04x}) at {}", reading.info.name,
                                    reading.info.vendor_id, reading.info.product_id,
                                    reading.info.location));
        lines.push_back("  " + reading.description.text);
        lines.push_back("  " + describe_pace(reading));
        append_report(reading, lines);
        if (!reading.first_broken.empty())
            lines.push_back("  broken: " + reading.first_broken);
        for (auto const& fault : reading.height_faults)
            lines.push_back("  " + fault);
    }
    for (auto& line : lines)
        line.resize(std::min(line.size(), std::max<std::size_t>(width, 20)));
    return lines;
}

} // namespace tractus::devices
