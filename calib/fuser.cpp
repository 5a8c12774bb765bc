#include "calib/fuser.h"

#include <algorithm>
#include <utility>

namespace tractus::calib {

Fuser::Fuser(Rig const& rig)
    : rig_(rig)
    , T_world_tablet_(calib::T_world_tablet(rig))
    , calibrated_(calibrated_heights(rig))
    , heights_(kPatience + rig.max_height_age + HeightTrack::kHalfWidth)
    , leans_(kPatience + rig.max_height_age + LeanTrack::kHalfWidth)
{
}

Fuser::Fuser(Rig const& rig, ScriptedHeight const& height)
    : Fuser(rig)
{
    scripted_ = height;
}

// The hand's pressure in place of the device's.
drivers::PenSample Fuser::as_felt(drivers::PenSample pen)
{
    if (!pen.pressure)
        return pen;
    auto const& response = rig_.pressure;
    auto const least = presses_ ? response.threshold / 2 : response.threshold;
    presses_ = pen.touching && (response.threshold == 0 || *pen.pressure > least);
    pen.touching = presses_;
    pen.pressure = respond(response, *pen.pressure);
    return pen;
}

// Pens that report no pressure press fully while they touch.
static double pressure(drivers::PenSample const& pen)
{
    return pen.pressure ? std::clamp(*pen.pressure, 0.0, 1.0) : (pen.touching ? 1.0 : 0.0);
}

// The way the pen's shaft points, turned as the tablet is mounted.
static std::optional<Vec2> tilt_rad(drivers::PenSample const& pen,
                                    Eigen::Affine3d const& T_world_tablet)
{
    if (!pen.tilt_rad)
        return std::nullopt;
    Vec3 const shaft(std::tan(pen.tilt_rad->x()), std::tan(pen.tilt_rad->y()), 1);
    Vec3 const turned = T_world_tablet.linear() * shaft;
    return Vec2(std::atan2(turned.x(), turned.z()), std::atan2(turned.y(), turned.z()));
}

TipSample Fuser::tip(drivers::PenSample const& pen, HeightTrack::Estimate const& height) const
{
    Vec2 const nib = nib_mm(pen, leans_, rig_);
    Vec3 const tablet_mm(nib.x(), nib.y(), height.height_mm);
    return {
        .time = instant(pen),
        .position_mm = T_world_tablet_ * tablet_mm,
        .pressure = pressure(pen),
        .tilt_rad = tilt_rad(pen, T_world_tablet_),
        .touching = pen.touching,
        .eraser = pen.eraser,
        .height_source = height.kind,
        .outside_calibration = !is_calibrated(height.height_mm),
    };
}

std::optional<HeightTrack::Estimate> Fuser::height_at(drivers::PenSample const& pen) const
{
    if (!scripted_)
        return heights_.at(instant(pen), rig_.max_height_age);
    double const height = height_mm(scripted_->scenario, pen.time - scripted_->first_pen,
                                    scripted_->last_pen - scripted_->first_pen);
    return HeightTrack::Estimate { height, TipSample::HeightSource::Interpolated };
}

std::optional<HeightTrack::Estimate> Fuser::live_height_at(drivers::PenSample const& pen) const
{
    return scripted_
        ? height_at(pen)
        : heights_.newest_at(instant(pen), rig_.max_height_age, height_times_.burst_interval());
}

bool Fuser::is_calibrated(double height_mm) const
{
    return scripted_ || !calibrated_
        || (height_mm >= calibrated_->low_mm - kCalibrationMargin_mm
            && height_mm <= calibrated_->high_mm + kCalibrationMargin_mm);
}

// Whether later readings, should they come in order, cannot change the height at `pen` any more.
bool Fuser::has_all_readings(drivers::PenSample const& pen) const
{
    return scripted_
        || (!heights_.empty() && heights_.newest() >= instant(pen) + HeightTrack::kHalfWidth);
}

void Fuser::push(drivers::HeightSample const& sample)
{
    ++counts_.heights;
    if (scripted_)
        return;
    auto const time = has_times_evened() ? height_times_.add(sample.time) : sample.time;
    bool const ours = sample.full_scale == rig_.full_scale_counts && sample.counts >= 0
        && sample.counts <= sample.full_scale;
    auto const height = ours ? height_mm(rig_.height_model, sample.counts) : std::nullopt;
    if (!height) {
        ++counts_.heights_refused;
        return;
    }
    if (sample.counts < rig_.calibrated_min_counts || sample.counts > rig_.calibrated_max_counts)
        ++counts_.heights_uncalibrated;
    heights_.add(time - rig_.height_latency, *height);
    settle_ready();
}

// A stroke must not lead across samples that were left out.
static void lift_after_gap(TipSample& tip, bool& gap)
{
    if (std::exchange(gap, false)) {
        tip.touching = false;
        tip.pressure = 0;
    }
}

std::optional<TipSample> Fuser::push(drivers::PenSample const& reported)
{
    auto pen = as_felt(reported);
    if (has_times_evened())
        pen.time = pen_times_.add(pen.time);
    if (!rig_.coil_height_mm.isZero(0))
        leans_.add(pen);
    ++counts_.pens;
    pending_.push_back(pen);
    settle_ready();

    auto const height = live_height_at(pen);
    if (!height) {
        gap_before_live_ = true;
        return std::nullopt;
    }
    auto live = tip(pen, *height);
    if (!has_all_readings(pen))
        live.height_source = TipSample::HeightSource::Extrapolated;
    lift_after_gap(live, gap_before_live_);
    return live;
}

void Fuser::settle_ready()
{
    // A pen sample that has waited so long has lost its heights. (Or the clock has jumped back.)
    auto const given_up = [&](drivers::PenSample const& pen) {
        return std::chrono::abs(pending_.back().time - pen.time) > kPatience + rig_.max_height_age;
    };
    while (!pending_.empty() && (has_all_readings(pending_.front()) || given_up(pending_.front())))
        settle_next();
}

void Fuser::settle_next()
{
    auto const& pen = pending_.front();
    if (auto const height = height_at(pen)) {
        settled_.push_back(tip(pen, *height));
        lift_after_gap(settled_.back(), gap_before_settled_);
        ++counts_.settled;
        counts_.settled_uncalibrated += settled_.back().outside_calibration;
    } else {
        gap_before_settled_ = true;
        ++counts_.pens_without_height;
    }
    pending_.pop_front();
}

std::vector<TipSample> Fuser::take_settled()
{
    return std::exchange(settled_, {});
}

void Fuser::flush()
{
    while (!pending_.empty())
        settle_next();
}

} // namespace tractus::calib
