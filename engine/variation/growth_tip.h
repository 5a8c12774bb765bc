#pragma once

#include "engine/plant/plant.h"
#include "engine/stroke/frame_rotation.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus {

// The inner loop of growth: where the tip of an axis points, segment by segment, in the coordinates
// of the axis (of the predefined plant, which what bears the axis has turned as a whole). All
// angles are deviations from a segment's predefined direction, in radians, towards its normal and
// binormal.

// A deviation beyond this, in radians, is held: a tip that looks back has turned far enough.
constexpr double kMostDeviation = 3;

// cos(a / 2) and sin(a / 2) / a of an angle 0 to pi, given by its square. Both are series in a²: no
// square root, no division, and exact for 0.
struct HalfAngle {
    double cosine = 1;
    double sine_share = 0.5;
};

template<std::size_t kTerms> HalfAngle half_angle_series(double y)
{
    // 1/(2n)! and 1/(2n+1)! with alternating signs.
    constexpr std::array<double, 12> kCosine {
        1,
        -1 / 2.,
        1 / 24.,
        -1 / 720.,
        1 / 40320.,
        -1 / 3628800.,
        1 / 479001600.,
        -1 / 87178291200.,
        1 / 20922789888000.,
        -1 / 6402373705728000.,
        1 / 2432902008176640000.,
        -1 / 1124000727777607680000.,
    };
    double cosine = 0;
    double sine = 0;
    for (std::size_t n = kTerms; n-- > 0;) {
        cosine = cosine * y + kCosine[n];
        sine = sine * y + kCosine[n] / (2 * static_cast<double>(n) + 1);
    }
    return { cosine, sine / 2 };
}

inline HalfAngle half_angle(double angle_squared)
{
    // The first term left out is below 1e-16 of 1. Most deviations are below the 36 degrees for
    // which few terms do.
    double const y = angle_squared / 4;
    return y < 0.1 ? half_angle_series<7>(y) : half_angle_series<12>(y);
}

inline Vec2 held(Vec2 const& deviation)
{
    double const squared = deviation.squaredNorm();
    if (squared <= kMostDeviation * kMostDeviation) [[likely]]
        return deviation;
    return deviation * (kMostDeviation / std::sqrt(squared));
}

// The direction that deviates by `d` from a segment's predefined one, in the segment's frame;
// `half` is that of |d|.
inline Vec3 deviated(Vec2 const& d, HalfAngle const& half)
{
    double const sine_share = 2 * half.sine_share * half.cosine;
    double const cosine = 1 - 2 * half.sine_share * half.sine_share * d.squaredNorm();
    return { cosine, sine_share * d.x(), sine_share * d.y() };
}

// The rotation without twist that does the same, in the segment's frame.
inline Quat turn_by(Vec2 const& d, HalfAngle const& half)
{
    return Quat(half.cosine, 0, -half.sine_share * d.y(), half.sine_share * d.x());
}

// The part of `influence` across the direction that deviates by `d`, on the segment's two sides.
// `influence` is in the segment's frame.
inline Vec2 across(Vec2 const& d, Vec3 const& influence)
{
    Vec3 const direction = deviated(d, half_angle(d.squaredNorm()));
    Vec3 const push = influence - influence.dot(direction) * direction;
    return push.tail<2>();
}

// What pushes an axis, in the axis' coordinates.
class AxisInfluence {
public:
    // `turn` takes the axis' coordinates to the plant's.
    AxisInfluence(GrowthPlan const& plan, Quat const& turn)
        : plan_(plan)
        , from_plant_(turn.conjugate())
        , everywhere_(from_plant_ * plan.influence.everywhere)
    {
    }

    // In the segment's frame.
    Vec3 at(SegmentId segment) const
    {
        Quat const to_segment = plan_.segments[segment].frame.conjugate();
        if (plan_.influence.local.empty())
            return to_segment * everywhere_;
        return to_segment * (everywhere_ + from_plant_ * plan_.influence.local[segment]);
    }

private:
    GrowthPlan const& plan_;
    Quat from_plant_;
    Vec3 everywhere_;
};

// The tip of one axis by the law without delay and maturation. A few multiplications per segment,
// all coefficients being in the plan.
class Tip {
public:
    // Plan and noise must outlive the tip.
    Tip(GrowthPlan const& plan, GrowthNoise const& noise, AxisId axis,
        AxisInfluence const& influence)
        : plan_(plan)
        , noise_(noise)
        , axis_(axis)
        , first_segment_(plan.base.axes[axis].first_segment)
        , influence_(influence)
        , is_pushed_(!plan.influence.is_none() && plan.parameters.indicator_gain != 0)
        , is_noisy_(plan.parameters.strength * plan.parameters.noise_rad != 0)
    {
    }

    // The deviations of the next segments: GrowthNoise::kBatch at most.
    void advance(std::span<Vec2> deviations)
    {
        std::array<StepNoise, GrowthNoise::kBatch> noise;
        if (is_noisy_)
            noise_.fill(axis_, next_, std::span(noise).first(deviations.size()));
        for (std::size_t i = 0; i < deviations.size(); ++i) {
            step(is_noisy_ ? &noise[i] : nullptr);
            deviations[i] = deviation_;
        }
    }

private:
    void step(StepNoise const* noise)
    {
        auto const segment = first_segment_ + next_;
        auto const& step = plan_.steps[plan_.segments[segment].step];
        // The indicators act on the tip as it was: on the segment before.
        Vec2 next = is_pushed_ ? pushed(next_ > 0 ? segment - 1 : segment, step)
                               : Vec2(step.deviation_kept * deviation_);
        if (noise) {
            Vec2 const first(noise->first[0], noise->first[1]);
            Vec2 const second(noise->second[0], noise->second[1]);
            next += step.noise_push * memory_ + step.noise_1 * first;
            memory_ = step.memory_kept * memory_ + step.memory_1 * first + step.memory_2 * second;
        }
        if (!plan_.circumnutation_rad.empty())
            next += plan_.circumnutation_rad[segment];
        deviation_ = held(next);
        ++next_;
    }

    Vec2 pushed(SegmentId segment, GrowthStep const& step) const
    {
        Vec3 const influence = influence_.at(segment);
        Vec2 d = deviation_;
        for (int part = 0; part < step.substeps; ++part)
            d = held(step.substep_kept * d + step.substep_push * across(d, influence));
        return d;
    }

    GrowthPlan const& plan_;
    GrowthNoise const& noise_;
    AxisId axis_ = 0;
    SegmentId first_segment_ = 0;
    AxisInfluence const& influence_;
    bool is_pushed_ = false;
    bool is_noisy_ = false;
    std::uint32_t next_ = 0; // Number in the axis of the segment to come.
    Vec2 deviation_ = Vec2::Zero();
    Vec2 memory_ = Vec2::Zero();
};

// How far an axis has come.
struct AxisProgress {
    double along_mm = 0; // The apex, from the base.
    double ripe = 1;     // Of the time to mature after the apex has reached the end: 0 to 1.
};

// The tip of one axis by the law with delay or maturation. Neither can be integrated over a segment
// at once, so this takes whole steps of the law, and a segment's deviation is read between two of
// them.
class SteppedTip {
public:
    // Grows the axis as far as `progress` says. Plan and noise need not outlive it.
    SteppedTip(GrowthPlan const& plan, GrowthNoise const& noise, AxisId axis,
               AxisInfluence const& influence, AxisProgress const& progress);

    // The deviations of the next segments.
    void advance(std::span<Vec2> deviations);

private:
    void grow(GrowthNoise const& noise, AxisId axis, std::size_t steps);
    void find_influence(AxisInfluence const& influence, std::size_t steps);
    void mature(std::size_t begin, std::size_t end);
    double length_of(std::uint32_t segment) const; // In steps.

    GrowthPlan const& plan_;
    SegmentId first_segment_ = 0;
    std::uint32_t segment_count_ = 0;
    double unit_mm_ = 0;
    bool per_length_ = true;

    // By the number of steps from the base.
    std::vector<Vec2> deviation_;
    std::vector<Vec3> influence_; // In the frame of the segment there; empty where there is none.

    std::uint32_t next_ = 0; // Number in the axis of the segment to come.
    double next_start_ = 0;  // Where it begins, in steps from the base.
};

} // namespace tractus
