#include "engine/variation/motion_indicator.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus::variation {

Result<MotionIndicator> motion_indicator(Stroke const& stroke)
{
    if (stroke.tips.empty())
        return fail(Fault::User, "the motion indicator has no points: draw it again");
    MotionIndicator const indicator { stroke.tips.front().position_mm,
                                      stroke.tips.back().position_mm };
    if (!indicator.start_mm.allFinite() || !indicator.end_mm.allFinite())
        return fail(Fault::User, "an end of the motion indicator is not a number: draw it again");
    return indicator;
}

Result<void> check_indicator(Plant const& plant, MotionIndicator const& indicator)
{
    if (!indicator.start_mm.allFinite() || !indicator.end_mm.allFinite())
        return fail(Fault::User, "an end of the motion indicator is not a number: draw it again");
    if (indicator.reach_mm && !(*indicator.reach_mm > 0))
        return fail(Fault::User,
                    fmt::format("the motion indicator reaches {} mm: give it a reach above 0 mm",
                                *indicator.reach_mm));
    for (auto const segment : indicator.below)
        if (!indicator.is_orphaned && segment >= plant.segment_count())
            return fail(Fault::User,
                        fmt::format("the motion indicator acts on segment {}, which is not in the "
                                    "plant of {}: select the branch again",
                                    segment, plant.segment_count()));
    return {};
}

double distance_mm(MotionIndicator const& indicator, Vec3 const& point_mm)
{
    Vec3 const along = indicator.end_mm - indicator.start_mm;
    double const squared = along.squaredNorm();
    double const share = squared > 0
        ? std::clamp((point_mm - indicator.start_mm).dot(along) / squared, 0.0, 1.0)
        : 0;
    return (indicator.start_mm + share * along - point_mm).norm();
}

double falloff(MotionIndicator const& indicator, double distance_mm)
{
    if (!indicator.reach_mm)
        return 1;
    double const share = distance_mm / *indicator.reach_mm;
    double const left = std::max(0.0, 1 - share * share);
    return left * left;
}

std::optional<std::size_t> nearest_indicator(std::span<MotionIndicator const> indicators,
                                             Vec3 const& point_mm, double finger_mm)
{
    std::optional<std::size_t> nearest;
    double min_mm = finger_mm;
    for (std::size_t i = 0; i < indicators.size(); ++i)
        if (double const distance = distance_mm(indicators[i], point_mm); distance <= min_mm) {
            min_mm = distance;
            nearest = i;
        }
    return nearest;
}

} // namespace tractus::variation
