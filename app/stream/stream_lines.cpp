#include "app/stream/stream_lines.h"

#include <cstdlib>
#include <fmt/format.h>
#include <iterator>

namespace tractus::stream {

namespace {

// Formats a number with `count` decimals, and never as -0.
std::string decimals_text(double number, int count)
{
    auto text = fmt::format("{:.{}f}", number, count);
    bool const is_zero = text.find_first_not_of("-0.") == std::string::npos;
    return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string millimetres_text(double length_mm)
{
    return decimals_text(length_mm, 3);
}

// Formats a time in seconds to the nanosecond; a double would not be precise enough.
std::string seconds_text(Timestamp time)
{
    constexpr std::int64_t kPerSecond = 1'000'000'000;
    auto const nanoseconds = time.time_since_epoch().count();
    return fmt::format("{}{}.{:09}", nanoseconds < 0 ? "-" : "", std::abs(nanoseconds / kPerSecond),
                       std::abs(nanoseconds % kPerSecond));
}

std::string coordinates_text(Vec3 const& position_mm)
{
    return fmt::format("{},{},{}", millimetres_text(position_mm.x()),
                       millimetres_text(position_mm.y()), millimetres_text(position_mm.z()));
}

std::string pressure_text(double pressure)
{
    return decimals_text(pressure, 4);
}

} // namespace

std::string stream_line(Bounds const& volume_mm)
{
    auto const corners = volume_mm.empty()
        ? std::string("null")
        : fmt::format("[[{}],[{}]]", coordinates_text(volume_mm.min_mm),
                      coordinates_text(volume_mm.max_mm));
    return fmt::format(R"({{"type":"stream","version":{},"volume_mm":{}}})"
                       "\n",
                       kStreamVersion, corners);
}

std::string tip_line(station::PenMoment const& moment)
{
    auto text = fmt::format(
        R"({{"type":"tip","pen":{},"time_s":{},"position_mm":[{}],"pressure":{},)"
        R"("touching":{},"in_range":{},"eraser":{})",
        moment.device, seconds_text(moment.time), coordinates_text(moment.position_mm),
        pressure_text(moment.pressure), moment.touching, moment.in_range, moment.eraser);
    if (moment.tilt_rad)
        text += fmt::format(R"(,"tilt_deg":[{},{}])",
                            decimals_text(degrees(moment.tilt_rad->x()), 2),
                            decimals_text(degrees(moment.tilt_rad->y()), 2));
    return text + "}\n";
}

std::string stroke_line(std::size_t number, tools::ToolStroke const& stroke)
{
    auto const words = tools::words_for(stroke.tool);
    auto const& tips = stroke.stroke.tips;
    auto text = fmt::format(
        R"({{"type":"stroke","number":{},"tool":"{}","arguments":"{}","eraser":{},"tips":[)",
        number, words.name, words.arguments, tips.front().eraser);
    for (auto const& tip : tips)
        fmt::format_to(std::back_inserter(text), "{}[{},{},{}]", text.back() == '[' ? "" : ",",
                       coordinates_text(tip.position_mm), pressure_text(tip.pressure),
                       seconds_text(tip.time));
    return text + "]}\n";
}

std::string step_line(std::size_t number, Timestamp began, Timestamp time, Vec3 const& end_mm)
{
    return fmt::format(
        R"({{"type":"step","number":{},"stroke_time_s":{},"time_s":{},"position_mm":[{}]}})"
        "\n",
        number, seconds_text(began), seconds_text(time), coordinates_text(end_mm));
}

std::string lost_line(std::size_t tips)
{
    return fmt::format(R"({{"type":"lost","tips":{}}})"
                       "\n",
                       tips);
}

std::string end_line()
{
    return "{\"type\":\"end\"}\n";
}

} // namespace tractus::stream
