#include "calib/fuser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::calib {

Fuser::Fuser(Rig const& rig)
    : rig_(rig)
    , T_world_tablet_(calib::T_world_tablet(rig))
    , calibrated_(calibrated_heights(rig))
    , heights_(kPatience + rig.max_height_age + HeightTrack::kHalfWidth)
    , leans_(kPatience + rig.max_height_age + LeanTrack::kHalfWidth)
    , touch_(rig.tablet_latency)
{
}

Fuser::Fuser(Rig const& rig, ScriptedHeight const& height)
    : Fuser(rig)
{
    scripted_ = height;
}

// Replaces the device's pressure by the rig's pressure response.
drivers::PenSample Fuser::apply_pressure_response(drivers::PenSample pen)
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

// Returns the pressure; pens that report none press fully while they touch.
static double pressure(drivers::PenSample const& pen)
{
    return pen.pressure ? std::clamp(*pen.pressure, 0.0, 1.0) : (pen.touching ? 1.0 : 0.0);
}

// Returns the tilt of the pen's shaft, rotated from the tablet frame to the world frame.
static std::optional<Vec2> tilt_rad(drivers::PenSample const& pen,
                                    Eigen::Affine3d const& T_world_tablet)
{
    if (!pen.tilt_rad)
        return std::nullopt;
    Vec3 const shaft(std::tan(pen.tilt_rad->x()), std::tan(pen.tilt_rad->y()), 1);
    Vec3 const turned = T_world_tablet.linear() * shaft;
    return Vec2(std::atan2(turned.x(), turned.z()), std::atan2(turned.y(), turned.z()));
}

TipSample Fuser::tip(Moment const& moment, HeightTrack::Estimate const& height) const
{
    auto const& pen = moment.pen;
    Vec2 const nib = nib_mm(pen, leans_, rig_);
    Vec3 const tablet_mm(nib.x(), nib.y(), height.height_mm);
    return {
        .time = moment.instant,
        .position_mm = T_world_tablet_ * tablet_mm,
        .pressure = pressure(pen),
        .tilt_rad = tilt_rad(pen, T_world_tablet_),
        .touching = pen.touching,
        .eraser = pen.eraser,
        .height_source = height.kind,
        .outside_calibration = !is_calibrated(height.height_mm),
    };
}

std::optional<HeightTrack::Estimate> Fuser::height_at(Moment const& moment) const
{
    if (!scripted_)
        return moment.is_in_silence ? heights_.at_corner(moment.instant, rig_.max_height_age)
                                    : heights_.at(moment.instant, rig_.max_height_age);
    double const height = height_mm(scripted_->scenario, moment.pen.time - scripted_->first_pen,
                                    scripted_->last_pen - scripted_->first_pen);
    return HeightTrack::Estimate { height, TipSample::HeightSource::Interpolated };
}

std::optional<HeightTrack::Estimate> Fuser::live_height_at(Moment const& moment) const
{
    return scripted_
        ? height_at(moment)
        : heights_.newest_at(moment.instant, rig_.max_height_age, height_times_.burst_interval());
}

bool Fuser::is_calibrated(double height_mm) const
{
    return scripted_ || !calibrated_
        || (height_mm >= calibrated_->low_mm - kCalibrationMargin_mm
            && height_mm <= calibrated_->high_mm + kCalibrationMargin_mm);
}

// True if readings that arrive in order can no longer change the height at this instant.
bool Fuser::has_all_readings(Timestamp instant) const
{
    return scripted_
        || (!heights_.empty() && heights_.newest() >= instant + HeightTrack::kHalfWidth);
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
    HeightJudge::Reading const reading { time, time - rig_.height_latency, *height };
    believed_.clear();
    double const count_mm = mm_per_count_at(rig_.height_model, sample.counts).value_or(0);
    auto const verdict = judge_.judge(reading, std::abs(count_mm), believed_);
    for (auto const& one : believed_)
        believe(one);
    if (verdict == HeightJudge::Verdict::Doubted)
        doubt(reading.instant);
    follow_surface(sample.time);
    settle_ready();
}

void Fuser::miss_height(Timestamp received)
{
    judge_.miss();
    doubt(received - rig_.height_latency);
}

void Fuser::believe(HeightJudge::Reading const& reading)
{
    heights_.add(reading.instant, reading.height_mm);
    touch_.read(reading.instant);
}

void Fuser::doubt(Timestamp instant)
{
    ++counts_.heights_doubted;
    // After a step, correct readings are doubted too, until there are enough of them.
    if (judge_.doubted_in_a_row() > HeightJudge::kMaxWrong + HeightJudge::kFewInRun)
        heights_.end_bridge();
    else
        heights_.add_unknown(instant);
}

// Makes tips from height readings while the pen is silent.
void Fuser::follow_surface(Timestamp arrival)
{
    // After a gap, the stroke must first be ended by a tip that is made from a pen sample.
    if (gap_before_live_ || gap_before_settled_)
        return;
    for (auto const at : touch_.take_instants(arrival, heights_, rig_.max_height_age)) {
        Moment const moment { touch_.pen(), at, true, !is_silence_sure_ };
        auto const height = live_height_at(moment);
        if (!height)
            continue;
        live_in_silence_.push_back(tip(moment, *height));
        last_live_in_silence_ = at;
        pending_.push_back(moment);
    }
    if (!may_leave_silently_ && touch_.is_surely_resting(arrival))
        keep_silence();
}

// Treats the pen's silence as rest, so that the tips made during it are drawn.
void Fuser::keep_silence()
{
    is_silence_sure_ = true;
    settled_.insert(settled_.end(), doubtful_.begin(), doubtful_.end());
    doubtful_.clear();
    for (auto moment = pending_.rbegin(); moment != pending_.rend() && moment->is_in_doubt;
         ++moment)
        moment->is_in_doubt = false;
}

void Fuser::drop_pending_silence(Timestamp from)
{
    while (!pending_.empty() && pending_.back().is_in_silence && pending_.back().instant >= from)
        pending_.pop_back();
}

void Fuser::forget_silence()
{
    touch_.forget();
    drop_silence();
}

void Fuser::drop_silence()
{
    drop_pending_silence(Timestamp::min());
    doubtful_.clear();
}

// Keeps tips in time order. The corrected time of the sample that ends a silence may be earlier
// than the last tip made in the silence; the sample's tip is then moved after it.
static void put_after(TipSample& tip, Timestamp last_in_silence)
{
    if (tip.time <= last_in_silence)
        tip.time = last_in_silence + std::chrono::microseconds(1);
}

// Ends the stroke after a gap, since a stroke must not cross samples that were left out.
static void lift_after_gap(TipSample& tip, bool& gap)
{
    if (std::exchange(gap, false)) {
        tip.touching = false;
        tip.pressure = 0;
    }
}

std::optional<TipSample> Fuser::push(drivers::PenSample const& reported)
{
    auto pen = apply_pressure_response(reported);
    if (has_times_evened())
        pen.time = pen_times_.add(pen.time);
    if (!rig_.coil_height_mm.isZero(0))
        leans_.add(pen);
    follow_surface(reported.time);
    Moment const moment { pen, instant(pen), false };
    drop_pending_silence(moment.instant);
    if (touch_.hear(pen, reported.time) == SilentTouch::Silence::Loss)
        drop_silence();
    keep_silence();
    is_silence_sure_ = false;
    ++counts_.pens;
    pending_.push_back(moment);
    settle_ready();

    auto const height = live_height_at(moment);
    if (!height) {
        gap_before_live_ = true;
        return std::nullopt;
    }
    auto live = tip(moment, *height);
    if (!has_all_readings(moment.instant))
        live.height_source = TipSample::HeightSource::Extrapolated;
    lift_after_gap(live, gap_before_live_);
    put_after(live, last_live_in_silence_);
    return live;
}

void Fuser::settle_ready()
{
    // True if a sample has waited so long that its heights have been forgotten. The same holds for
    // samples from before a backward jump of the clock.
    auto const given_up = [&](Moment const& moment) {
        return std::chrono::abs(pending_.back().instant - moment.instant)
            > kPatience + rig_.max_height_age;
    };
    while (!pending_.empty()
           && (has_all_readings(pending_.front().instant) || given_up(pending_.front())))
        settle_next();
}

void Fuser::settle_next()
{
    auto const moment = pending_.front();
    pending_.pop_front();
    auto const height = height_at(moment);
    if (moment.is_in_silence) {
        if (!height)
            return;
        auto const settled = tip(moment, *height);
        (moment.is_in_doubt ? doubtful_ : settled_).push_back(settled);
        last_settled_in_silence_ = settled.time;
        ++counts_.settled_in_silence;
        counts_.settled_uncalibrated += settled.outside_calibration;
    } else if (height) {
        settled_.push_back(tip(moment, *height));
        lift_after_gap(settled_.back(), gap_before_settled_);
        put_after(settled_.back(), last_settled_in_silence_);
        ++counts_.settled;
        counts_.settled_uncalibrated += settled_.back().outside_calibration;
    } else {
        gap_before_settled_ = true;
        ++counts_.pens_without_height;
    }
}

std::vector<TipSample> Fuser::take_settled()
{
    return std::exchange(settled_, {});
}

void Fuser::flush()
{
    keep_silence();
    while (!pending_.empty())
        settle_next();
}

void Fuser::forget_heights()
{
    judge_ = {};
    heights_ = HeightTrack(kPatience + rig_.max_height_age + HeightTrack::kHalfWidth);
    height_times_ = {};
    touch_.forget();
    is_silence_sure_ = false;
}

} // namespace tractus::calib
