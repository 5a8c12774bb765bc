#include "calib/lean_track.h"

#include "calib/line_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::calib {

Vec2 lean_of(Vec2 const& tilt_rad)
{
    Vec3 const shaft(std::tan(tilt_rad.x()), std::tan(tilt_rad.y()), 1);
    return shaft.normalized().head<2>();
}

void LeanTrack::add(drivers::PenSample const& sample)
{
    if (!moments_.empty() && sample.time < moments_.back().time)
        moments_.clear();
    if (sample.tilt_rad)
        moments_.push_back({ sample.time, lean_of(*sample.tilt_rad) });
    while (!moments_.empty() && sample.time - moments_.front().time > memory_)
        moments_.pop_front();
}

std::optional<Vec2> LeanTrack::at(Timestamp time) const
{
    auto const not_before = [&](Timestamp from) {
        return std::lower_bound(moments_.begin(), moments_.end(), from,
                                [](Moment const& moment, Timestamp t) { return moment.time < t; });
    };
    auto const asked = not_before(time);
    if (asked == moments_.end() || asked->time != time)
        return std::nullopt;
    std::array<LineFit, 2> sums;
    for (auto moment = not_before(time - kHalfWidth);
         moment != moments_.end() && moment->time < time + kHalfWidth; ++moment) {
        double const distance = to_seconds(moment->time - time) / to_seconds(kHalfWidth);
        for (Eigen::Index axis = 0; axis < 2; ++axis)
            sums[static_cast<std::size_t>(axis)].add(to_seconds(moment->time - time),
                                                     moment->lean[axis], 1 - distance * distance);
    }
    auto const x = sums[0].line();
    auto const y = sums[1].line();
    return x && y ? Vec2(x->at_zero, y->at_zero) : asked->lean;
}

Vec2 nib_mm(drivers::PenSample const& sample, LeanTrack const& leans, Rig const& rig)
{
    if (rig.coil_height_mm.isZero(0) || !sample.tilt_rad)
        return sample.position_mm;
    auto const lean = leans.at(sample.time).value_or(lean_of(*sample.tilt_rad));
    return sample.position_mm - rig.coil_height_mm.cwiseProduct(lean);
}

} // namespace tractus::calib
