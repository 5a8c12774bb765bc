#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/growth_noise.h"
#include "engine/variation/growth_plan.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// Influence that pushes an axis, in the axis' coordinates.
class AxisInfluence {
public:
    // `turn` takes the axis' coordinates to the plant's.
    AxisInfluence(GrowthPlan const& plan, Quat const& turn)
        : plan_(plan)
        , from_plant_(turn.conjugate())
        , everywhere_(from_plant_ * plan.influence.everywhere)
    {
    }

    // Returns the influence in the segment's frame.
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

// How far an axis has come.
struct AxisProgress {
    double along_mm = 0; // The apex, from the base.
    double ripe = 1;     // Share of the time to mature after the apex has reached the end: 0 to 1.
};

// The tip of one axis by the law with delay or maturation: where it points, segment by segment, in
// the coordinates of the axis (of the predefined plant, which what bears the axis has turned as a
// whole). Neither can be integrated over a segment
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
    double length_of(std::uint32_t segment) const; // Length in steps.

    GrowthPlan const& plan_;
    SegmentId first_segment_ = 0;
    std::uint32_t segment_count_ = 0;
    double unit_mm_ = 0;
    bool per_length_ = true;

    // Deviations by the number of steps from the base.
    std::vector<Vec2> deviation_;
    // Influence in the frame of the segment there; empty where there is none.
    std::vector<Vec3> influence_;

    std::uint32_t next_ = 0; // Number in the axis of the segment to come.
    double next_start_ = 0;  // Where it begins, in steps from the base.
};

} // namespace tractus::variation
