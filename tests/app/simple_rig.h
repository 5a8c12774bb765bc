#pragma once

#include "app/station/station.h"
#include "tests/app/small_model.h"
#include "tests/drivers/devices.h"

#include <cstdint>

namespace tractus {

constexpr std::size_t kPen = 0;    // Index of the tablet in simple_rig().
constexpr std::size_t kHeight = 1; // Index of the height sensor in simple_rig().

inline std::vector<drivers::DeviceInfo> simple_rig()
{
    return { drivers::simple_pen(), drivers::simple_height_sensor() };
}

inline Timestamp at_ms(std::int64_t milliseconds)
{
    return timestamp_ns(milliseconds * 1'000'000);
}

inline void append_u16(std::vector<std::byte>& report, int value)
{
    report.push_back(static_cast<std::byte>(value & 0xff));
    report.push_back(static_cast<std::byte>(value >> 8));
}

// Returns the simple pen's report of a position, given by the distances from the left and from the
// far edge.
inline std::vector<std::byte> pen_report(double x_mm, double y_mm, bool touching)
{
    std::vector<std::byte> report { std::byte { 2 },
                                    touching ? std::byte { 0x21 } : std::byte { 0x20 } };
    append_u16(report, static_cast<int>(100 * x_mm));
    append_u16(report, static_cast<int>(100 * y_mm));
    append_u16(report, touching ? 1000 : 0);
    append_u16(report, 0); // Both tilts are 0.
    return report;
}

inline std::vector<std::byte> height_report(int counts)
{
    std::vector<std::byte> report { std::byte { 1 } };
    append_u16(report, counts);
    return report;
}

// Returns a station with the simple pen and the given tools. Its surface stays at a height of 100
// mm.
inline station::Station flat_station(tools::ToolKinds tools, std::optional<tools::Tool> const& tool)
{
    station::StationOptions options;
    options.scripted_height = calib::ScriptedHeight {
        .scenario = { .kind = calib::HeightScenario::Kind::Constant, .constant_mm = 100 },
        .first_pen = {},
        .last_pen = {},
    };
    options.tools = tools;
    options.tool = tool;
    return station::Station::create(std::vector { drivers::simple_pen() }, options).value();
}

// Draws a stroke across the middle of the tablet with the simple pen. From `start_ms` on, it sends
// twenty samples 5 ms apart, and then one sample of the lifted pen.
template<typename AnyStation> void draw_across(AnyStation& station, std::int64_t start_ms)
{
    for (int i = 0; i < 20; ++i)
        station.push(kPen, at_ms(start_ms + 5 * i), pen_report(50 + 5 * i, 50, true));
    station.push(kPen, at_ms(start_ms + 100), pen_report(150, 50, false));
}

} // namespace tractus
