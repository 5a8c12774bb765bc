#include "engine/variation/growth_tip.h"

namespace tractus {

DelayedTip::DelayedTip(GrowthPlan const& plan, GrowthNoise const& noise, AxisId axis,
                       Vec3 const& influence)
    : plan_(plan)
    , noise_(noise)
    , axis_(axis)
    , segments_(
          std::span(plan.segments)
              .subspan(plan.base.axes[axis].first_segment, plan.base.axes[axis].segment_count))
    , influence_(influence)
    , unit_mm_(plan.axis_length_mm[axis] / plan.parameters.steps_per_axis)
{
    under_end_ = length_of(0);
    history_.fill(Vec2::Zero());
}

void DelayedTip::advance(std::span<Vec2> deviations)
{
    bool const per_length = plan_.parameters.steps == GrowthParameters::Steps::PerLength;
    for (auto& deviation : deviations) {
        double const length = length_of(next_);
        deviation = deviation_at(per_length ? next_start_ + length / 2 : next_start_);
        next_start_ += length;
        ++next_;
    }
}

double DelayedTip::length_of(std::uint32_t segment) const
{
    if (plan_.parameters.steps == GrowthParameters::Steps::PerSegment)
        return 1;
    return unit_mm_ > 0 ? segments_[segment].length_mm / unit_mm_ : 0;
}

Vec2 DelayedTip::deviation_at(double place)
{
    while (steps_ < place)
        step();
    auto const& after = history_[steps_ % kHistory];
    if (steps_ == 0)
        return after;
    auto const& before = history_[(steps_ - 1) % kHistory];
    double const share = place - (steps_ - 1.0);
    return before + share * (after - before);
}

void DelayedTip::step()
{
    while (under_end_ <= steps_ && under_ + 1 < segments_.size())
        under_end_ += length_of(++under_);
    auto const in_batch = steps_ % GrowthNoise::kBatch;
    if (in_batch == 0)
        noise_.fill(axis_, steps_, batch_);

    auto const& parameters = plan_.parameters;
    auto const unit = unit_step(parameters);
    auto const delay = static_cast<std::uint32_t>(parameters.delay_steps);
    Vec2 const now = history_[steps_ % kHistory];
    Vec2 const felt = steps_ >= delay ? history_[(steps_ - delay) % kHistory] : Vec2(Vec2::Zero());
    Vec2 const first(batch_[in_batch].first[0], batch_[in_batch].first[1]);

    Vec2 next = now - parameters.gain * felt + unit.noise_push * memory_ + unit.noise_1 * first;
    memory_ = unit.memory_kept * memory_ + unit.memory_1 * first;
    if (!influence_.isZero(0)) {
        auto const& segment = segments_[under_];
        Vec3 const binormal = segment.direction.cross(segment.normal);
        next += unit.substep_push * across(segment, binormal, now, influence_);
    }
    if (double const a = parameters.circumnutation_rad * parameters.strength; a != 0) {
        double const phase = 2 * kPi * steps_ / parameters.circumnutation_period_steps;
        next += a * Vec2(std::cos(phase), std::sin(phase));
    }
    ++steps_;
    history_[steps_ % kHistory] = held(next);
}

} // namespace tractus
