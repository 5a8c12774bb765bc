#include "app/session/describe_edit.h"

#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>

namespace tractus {

namespace {

std::string file_name(std::string const& path)
{
    return std::filesystem::path(path).filename().string();
}

std::string counted(std::size_t count, char const* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

// "1, 2 and 3" for numbers that count from 0.
std::string list_numbers(std::vector<std::size_t> const& numbers)
{
    std::string list;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        list += fmt::format("{}{}",
                            i == 0                       ? ""
                                : i + 1 < numbers.size() ? ", "
                                                         : " and ",
                            numbers[i] + 1);
    return list;
}

std::string describe_stroke(Stroke const& stroke)
{
    double length_mm = 0;
    for (std::size_t i = 1; i < stroke.tips.size(); ++i)
        length_mm += (stroke.tips[i].position_mm - stroke.tips[i - 1].position_mm).norm();
    double const seconds
        = stroke.tips.empty() ? 0 : to_seconds(stroke.tips.back().time - stroke.tips.front().time);
    return fmt::format("{}, {:.0f} mm in {:.1f} s", counted(stroke.tips.size(), "tip"), length_mm,
                       seconds);
}

std::string describe_indicator(MotionIndicator const& indicator)
{
    Vec3 const way_mm = indicator.end_mm - indicator.start_mm;
    auto const whole = [](double mm) { return std::round(mm) + 0.0; }; // Never -0.
    auto text
        = fmt::format("({}, {}, {}) mm{}", whole(way_mm.x()), whole(way_mm.y()), whole(way_mm.z()),
                      indicator.kind == MotionIndicator::Kind::Light ? ", light" : "");
    if (!indicator.below.empty())
        text += fmt::format(", on {} and what they bear",
                            counted(indicator.below.size(), "segment"));
    if (indicator.reach_mm)
        text += fmt::format(", as far as {:.0f} mm", *indicator.reach_mm);
    return text;
}

char const* describe_drawn(Drawn drawn)
{
    return drawn == Drawn::Keep ? ", and keeps what was drawn" : "";
}

std::string described(LoadModel const& edit)
{
    auto text = fmt::format("takes the model {}: {} of rules", file_name(edit.source.name),
                            counted(edit.source.text.size(), "byte"));
    if (!edit.includes.empty())
        text += fmt::format(", {}", counted(edit.includes.size(), "more file"));
    if (edit.steps)
        text += fmt::format(
            ", {}", counted(static_cast<std::size_t>(std::max(*edit.steps, 0)), "derivation step"));
    return fmt::format("{}, seed {}{}", text, edit.seed, describe_drawn(edit.drawn));
}

std::string described(LoadSkeleton const& edit)
{
    return fmt::format("takes the skeleton {}: {}{}", file_name(edit.name),
                       counted(edit.lines.size(), "line"), describe_drawn(edit.drawn));
}

std::string described(Select const& edit)
{
    if (edit.paths.empty())
        return "selects nothing";
    std::size_t segments = 0;
    for (auto const& path : edit.paths)
        segments += path.size();
    return fmt::format("selects {}, {}", counted(edit.paths.size(), "path"),
                       counted(segments, "segment"));
}

std::string described(Associate const& edit)
{
    static constexpr std::array kWhat { "what is selected", "what the selected bears",
                                        "what is selected and bears" };
    static constexpr std::array kHow { "", ", tip where it was", ", as in the world" };
    return fmt::format("shapes {} by a stroke: {}{}",
                       kWhat[static_cast<std::size_t>(edit.propagation)],
                       describe_stroke(edit.stroke), kHow[static_cast<std::size_t>(edit.fit)]);
}

std::string described(Oversketch const& edit)
{
    return fmt::format("redraws a part of stroke {}: {}", list_numbers(edit.associations),
                       describe_stroke(edit.over));
}

std::string described(SmoothStroke const& edit)
{
    return fmt::format("smooths stroke {}, keeping {:.0f} % of the hand",
                       list_numbers(edit.associations), 100 * edit.detail_weight);
}

std::string described(DeleteStroke const& edit)
{
    return fmt::format("takes stroke {} away", list_numbers(edit.associations));
}

std::string described(EraseTips const& edit)
{
    std::size_t count = 0;
    for (auto const& [first, last] : edit.ranges)
        count += last + 1 - first;
    return fmt::format("erases {} of stroke {}", counted(count, "tip"),
                       list_numbers(edit.associations));
}

std::string described(Indicate const& edit)
{
    return fmt::format("leans the plant by {}", describe_indicator(edit.indicator));
}

std::string described(ChangeIndicator const& edit)
{
    return fmt::format("changes motion indicator {}: {}", edit.number + 1,
                       describe_indicator(edit.indicator));
}

std::string described(DeleteIndicator const& edit)
{
    return fmt::format("takes motion indicator {} away", edit.number + 1);
}

std::string described(SetGrowth const& edit)
{
    auto const preset = growth_preset_of(edit.parameters);
    auto text = preset.empty() ? fmt::format("grows with strength {:.3g}, gain {:.3g}",
                                             edit.parameters.strength, edit.parameters.gain)
                               : fmt::format("grows as \"{}\"", preset);
    if (edit.variability != 1)
        text += fmt::format(", {:.3g} as it likes", edit.variability);
    if (edit.age != 1)
        text += fmt::format(", to age {:.3g}", edit.age);
    return text + fmt::format(", seed {}", edit.seed);
}

} // namespace

std::string describe_edit(Edit const& edit)
{
    return std::visit([](auto const& kind) { return described(kind); }, edit);
}

} // namespace tractus
