#include "engine/variation/motion_indicator.h"

#include "engine/base/check.h"

namespace tractus {

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

Vec3 summed_influence(std::span<MotionIndicator const> indicators, double shown_height_mm)
{
    CHECK(shown_height_mm > 0);
    Vec3 sum_mm = Vec3::Zero();
    for (auto const& indicator : indicators)
        sum_mm += indicator.end_mm - indicator.start_mm;
    return sum_mm / shown_height_mm;
}

} // namespace tractus
