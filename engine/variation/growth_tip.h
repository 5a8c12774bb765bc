#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// The influence that acts on an axis, in coordinates that are rotated with the axis' parent.
class AxisInfluence {
public:
    // `turn`: rotation from the axis' coordinates to the plant's.
    AxisInfluence(GrowthPlan const& plan, Quat const& turn)
        : plan_(plan)
        , from_plant_(turn.conjugate())
        , everywhere_(from_plant_ * plan.influence.everywhere)
    {
    }

    // Returns the influence at a segment, in the segment's frame.
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

// How far an axis has grown at an age of the plant.
struct AxisProgress {
    double along_mm = 0; // Position of the apex, from the axis' base.
    // Share of the maturation time that has passed since the apex reached the axis' end: 0 to 1.
    double ripe = 1;
};

// The tip of one axis with delay or maturation: its deviation segment by segment, in the
// coordinates of the axis (those of the predefined plant, rotated with the axis' parent). With
// delay or maturation the law cannot be integrated over a segment in closed form, so this class
// takes whole steps and interpolates each segment's deviation between two steps.
class SteppedTip {
public:
    // Grows the axis up to `progress`. `plan` must outlive the object; the other arguments need
    // not.
    SteppedTip(GrowthPlan const& plan, GrowthNoise const& noise, AxisId axis,
               AxisInfluence const& influence, AxisProgress const& progress);

    // Fills `deviations` with the deviations of the next segments of the axis.
    void advance(std::span<Vec2> deviations);

private:
    void grow(GrowthNoise const& noise, AxisId axis, std::size_t steps);
    void find_influence(AxisInfluence const& influence, std::size_t steps);
    void mature(std::size_t begin, std::size_t end);
    double length_of(std::uint32_t segment) const; // Length of a segment, in steps.

    GrowthPlan const& plan_;
    SegmentId first_segment_ = 0;
    std::uint32_t segment_count_ = 0;
    double unit_mm_ = 0;
    bool per_length_ = true;

    // Element n: deviation of the tip n steps from the base.
    std::vector<Vec2> deviation_;
    // Element n: influence on the tip n steps from the base, in the frame of the segment there.
    // Empty if there is no influence.
    std::vector<Vec3> influence_;

    // Number of the segment that advance() handles next, from 0 at the axis' base.
    std::uint32_t next_ = 0;
    double next_start_ = 0; // Beginning of segment next_, in steps from the base.
};

} // namespace tractus::variation
