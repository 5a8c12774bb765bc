#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/rest_shape.h"

#include <algorithm>
#include <vector>

namespace tractus::variation {

// The age of a plant runs from 0, nothing, to 1, the whole plant. The skeleton is complete at this
// age; what was born last has the rest of the time to become thick, and its leaves to unfold.
constexpr double kSkeletonShare = 0.85;

// When an axis grows. Its apex starts when the segment that bears it is complete, and advances so
// fast that the farthest tip of all that it will bear is reached when the skeleton is complete. So
// the longest way through the plant grows evenly, and every part of it grows to the end.
struct AxisAge {
    double begin = 0;    // Age of the plant; 0 to kSkeletonShare.
    double reach_mm = 0; // Reach from the axis' base along branches to the farthest tip above it.

    // Age of the plant when the apex has come so far along the axis.
    double birth_at(double along_mm) const
    {
        return reach_mm > 0 ? begin + (kSkeletonShare - begin) * std::min(along_mm / reach_mm, 1.0)
                            : begin;
    }

    // The way back: how far the apex has come at an age, at most to the reach; nothing before its
    // birth.
    double along_at_mm(double age) const
    {
        if (age >= kSkeletonShare)
            return reach_mm;
        return age > begin ? reach_mm * (age - begin) / (kSkeletonShare - begin) : 0;
    }
};

// One per axis. `rest` is the plant's shape.
std::vector<AxisAge> find_axis_ages(Plant const& plant, RestShape const& rest);

// How far something is that was born at `birth`, 0 to kSkeletonShare, when the plant is of `age`: 0
// to 1, and 1 for the whole plant.
inline double ripeness(double age, double birth)
{
    return std::clamp((age - birth) / (1 - birth), 0.0, 1.0);
}

// How far an organ has unfolded, which takes a short time and goes without a jerk.
inline double unfolded(double age, double birth)
{
    double const t = std::clamp((age - birth) / (1 - kSkeletonShare), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace tractus::variation
