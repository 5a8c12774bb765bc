#include "engine/scene/edit_words.h"

#include <fmt/core.h>

namespace tractus::scene {

std::string counted(std::size_t count, char const* what)
{
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

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
    // In a session edited by hand, the times may be too far apart for a Duration.
    double const seconds = stroke.tips.empty()
        ? 0
        : to_seconds(stroke.tips.back().time) - to_seconds(stroke.tips.front().time);
    return fmt::format("{}, {:.0f} mm in {:.1f} s", counted(stroke.tips.size(), "tip"), length_mm,
                       seconds);
}

} // namespace tractus::scene
