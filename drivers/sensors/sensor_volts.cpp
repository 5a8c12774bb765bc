#include "drivers/sensors/sensor_volts.h"

#include <charconv>
#include <fmt/core.h>

namespace tractus::drivers {

static constexpr std::string_view kPerCount = " V per count from ";

std::string print_volts_per_count(double volts_per_count, double volts_at_zero)
{
    return fmt::format("{:.6g}{}{:.6g} V", volts_per_count, kPerCount, volts_at_zero);
}

static std::optional<double> leading_number(std::string_view text)
{
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<double> sensor_volts(std::string_view name, double counts)
{
    auto const at = name.rfind(kPerCount);
    if (at == std::string_view::npos)
        return std::nullopt;
    auto const blank = name.substr(0, at).rfind(' ');
    auto const slope
        = leading_number(name.substr(blank + 1)); // Without a blank, npos + 1 is 0, the beginning.
    auto const offset = leading_number(name.substr(at + kPerCount.size()));
    return slope && offset ? std::optional(*slope * counts + *offset) : std::nullopt;
}

} // namespace tractus::drivers
