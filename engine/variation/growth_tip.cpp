#include "engine/variation/growth_tip.h"

#include "engine/variation/deviation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::variation {

SteppedTip::SteppedTip(GrowthPlan const& plan, GrowthNoise const& noise, AxisId axis,
                       AxisInfluence const& influence, AxisProgress const& progress)
    : plan_(plan)
    , first_segment_(plan.base.axes[axis].first_segment)
    , segment_count_(plan.base.axes[axis].segment_count)
    , unit_mm_(plan.axis_length_mm[axis] / plan.parameters.steps_per_axis)
    , per_length_(plan.parameters.steps == GrowthParameters::Steps::PerLength)
{
    // Number of steps along the axis: over its whole length with PerLength, up to the base of its
    // last segment with PerSegment.
    double const last
        = per_length_ ? plan.parameters.steps_per_axis : static_cast<double>(segment_count_ - 1);
    auto const all = static_cast<std::size_t>(std::ceil(last));
    double const share
        = plan.axis_length_mm[axis] > 0 ? progress.along_mm / plan.axis_length_mm[axis] : 1;
    auto const steps
        = std::min(all, static_cast<std::size_t>(std::ceil(last * std::min(share, 1.0))));
    if (!plan.influence.is_none())
        find_influence(influence, all);
    grow(noise, axis, steps);
    auto const zone = static_cast<std::size_t>(plan.parameters.growth_zone_steps);
    auto const rest
        = static_cast<std::size_t>(std::lround(static_cast<double>(zone) * progress.ripe));
    for (std::size_t i = 1; steps == all && i <= rest; ++i)
        mature(steps + i > zone ? steps + i - zone : 0, steps);
    // Segments that have not grown yet get the deviation of the tip.
    deviation_.resize(all + 1, deviation_.back());
}

double SteppedTip::length_of(std::uint32_t segment) const
{
    if (!per_length_)
        return 1;
    return unit_mm_ > 0 ? plan_.segments[first_segment_ + segment].length_mm / unit_mm_ : 0;
}

void SteppedTip::find_influence(AxisInfluence const& influence, std::size_t steps)
{
    influence_.reserve(steps + 1);
    // Number of the segment that contains the tip. It ends `under_end` steps from the axis' base.
    std::uint32_t under = 0;
    double under_end = length_of(0);
    Vec3 felt = influence.at(first_segment_);
    for (std::size_t step = 0; step <= steps; ++step) {
        bool moved = false;
        while (under_end <= static_cast<double>(step) && under + 1 < segment_count_) {
            under_end += length_of(++under);
            moved = true;
        }
        if (moved)
            felt = influence.at(first_segment_ + under);
        influence_.push_back(felt);
    }
}

void SteppedTip::grow(GrowthNoise const& noise, AxisId axis, std::size_t steps)
{
    auto const& parameters = plan_.parameters;
    auto const unit = unit_step(parameters);
    auto const delay = static_cast<std::size_t>(parameters.delay_steps);
    auto const zone = static_cast<std::size_t>(parameters.growth_zone_steps);
    double const swing = parameters.circumnutation_rad * parameters.strength;
    std::array<StepNoise, 64> batch;
    Vec2 memory = Vec2::Zero();
    deviation_.reserve(steps + 1);
    deviation_.push_back(Vec2::Zero());
    for (std::size_t n = 0; n < steps; ++n) {
        auto const in_batch = n % batch.size();
        if (in_batch == 0)
            noise.fill(axis, static_cast<std::uint32_t>(n),
                       std::span(batch).first(std::min(batch.size(), steps - n)));
        Vec2 const felt = n >= delay ? deviation_[n - delay] : Vec2(Vec2::Zero());
        Vec2 const first(batch[in_batch].first[0], batch[in_batch].first[1]);

        Vec2 next = deviation_[n] - parameters.gain * felt + unit.noise_push * memory
            + unit.noise_1 * first;
        memory = unit.memory_kept * memory + unit.memory_1 * first;
        if (!influence_.empty())
            next += unit.substep_push * across(deviation_[n], influence_[n]);
        if (swing != 0) {
            double const phase
                = 2 * kPi * static_cast<double>(n) / parameters.circumnutation_period_steps;
            next += swing * Vec2(std::cos(phase), std::sin(phase));
        }
        deviation_.push_back(held(next));
        if (zone > 0)
            mature(n + 1 > zone ? n + 1 - zone : 0, n + 1);
    }
}

// Applies one step of maturation to the bends between successive deviations, from step `begin` to
// step `end`.
void SteppedTip::mature(std::size_t begin, std::size_t end)
{
    double const bending = plan_.parameters.maturation_bending;
    double const kept = 1 - plan_.parameters.maturation_straightening;
    if (begin >= end)
        return;
    // Deviation at the lower end of the current piece: `below` before this step of maturation,
    // `now` after it.
    Vec2 below = deviation_[begin];
    Vec2 now = below;
    for (std::size_t n = begin + 1; n <= end; ++n) {
        Vec2 change = kept * (deviation_[n] - below);
        if (!influence_.empty()) {
            // An influence bends a piece across the piece's direction, taken half-way between its
            // two ends.
            Vec2 const middle = (below + deviation_[n]) / 2;
            Quat const turn = turn_by(middle, half_angle(middle.squaredNorm()));
            change += bending * (turn.conjugate() * influence_[n - 1]).tail<2>();
        }
        below = deviation_[n];
        now = held(now + change);
        deviation_[n] = now;
    }
}

void SteppedTip::advance(std::span<Vec2> deviations)
{
    for (auto& deviation : deviations) {
        double const length = length_of(next_);
        double const place = per_length_ ? next_start_ + length / 2 : next_start_;
        auto const after
            = std::min(static_cast<std::size_t>(std::ceil(place)), deviation_.size() - 1);
        auto const before = after > 0 ? after - 1 : 0;
        double const share = std::min(place - static_cast<double>(before), 1.0);
        deviation = deviation_[before] + share * (deviation_[after] - deviation_[before]);
        next_start_ += length;
        ++next_;
    }
}

} // namespace tractus::variation
