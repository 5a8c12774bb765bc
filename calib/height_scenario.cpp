#include "calib/height_scenario.h"

#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus::calib {

struct NamedScenario {
    std::string_view name;
    HeightScenario::Kind kind;
};

static constexpr std::array kScenarios {
    NamedScenario { "rise", HeightScenario::Kind::Rise },
    NamedScenario { "fall", HeightScenario::Kind::Fall },
    NamedScenario { "arch", HeightScenario::Kind::Arch },
    NamedScenario { "sway", HeightScenario::Kind::Sway },
};

static constexpr double kLowest_mm = 50;
static constexpr double kTravel_mm = 300;
static constexpr double kFarthest_mm = 10'000; // A greater height is a typing error.
static constexpr double kSwayPeriod_s = 8;

Result<HeightScenario> parse_height_scenario(std::string_view text)
{
    for (auto const& scenario : kScenarios)
        if (scenario.name == text)
            return HeightScenario { .kind = scenario.kind };

    double number = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
        return fail(
            Fault::User,
            fmt::format("unknown height \"{}\": give millimetres, rise, fall, arch or sway", text));
    if (std::abs(number) > kFarthest_mm)
        return fail(Fault::User,
                    fmt::format("the height {} mm is out of reach: give {} to {} mm", text,
                                -kFarthest_mm, kFarthest_mm));
    return HeightScenario { .kind = HeightScenario::Kind::Constant, .constant_mm = number };
}

double height_mm(HeightScenario const& scenario, Duration since_first, Duration length)
{
    auto const passed = std::clamp(since_first, Duration(0), std::max(length, Duration(0)));
    double const part = length > Duration(0) ? to_seconds(passed) / to_seconds(length) : 0;
    switch (scenario.kind) {
    case HeightScenario::Kind::Constant:
        return scenario.constant_mm;
    case HeightScenario::Kind::Rise:
        return kLowest_mm + kTravel_mm * part;
    case HeightScenario::Kind::Fall:
        return kLowest_mm + kTravel_mm * (1 - part);
    case HeightScenario::Kind::Arch:
        return kLowest_mm + kTravel_mm * std::sin(kPi * part);
    case HeightScenario::Kind::Sway:
        return kLowest_mm
            + kTravel_mm * (1 + std::sin(2 * kPi * to_seconds(passed) / kSwayPeriod_s)) / 2;
    }
    return scenario.constant_mm;
}

} // namespace tractus::calib
