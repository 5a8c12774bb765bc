#pragma once

#include "engine/plant/plant.h"
#include "engine/variation/rest_shape.h"

#include <algorithm>
#include <vector>

namespace tractus::variation {

// Age at which a plant's skeleton is complete. Ages run from 0 (nothing) to 1 (the whole plant).
// From this age to 1 the youngest parts thicken and unfold their leaves.
constexpr double kSkeletonShare = 0.85;

// Growth period of an axis. The apex starts when the parent segment is complete. It advances at the
// speed that completes the longest path from the axis to a tip at the age kSkeletonShare. So the
// longest path through the plant grows evenly, and every axis has growing tips until that age.
struct AxisAge {
    double begin = 0; // Age of the plant at which the axis starts, 0 to kSkeletonShare.
    // Distance along branches from the axis' base to the farthest tip above it.
    double reach_mm = 0;

    // Age of the plant when the apex has advanced `along_mm` from the axis' base.
    double birth_at(double along_mm) const
    {
        return reach_mm > 0 ? begin + (kSkeletonShare - begin) * std::min(along_mm / reach_mm, 1.0)
                            : begin;
    }

    // The inverse of birth_at(): distance by which the apex has advanced at an age, at most
    // `reach_mm`; 0 before the axis starts.
    double along_at_mm(double age) const
    {
        if (age >= kSkeletonShare)
            return reach_mm;
        return age > begin ? reach_mm * (age - begin) / (kSkeletonShare - begin) : 0;
    }
};

// Returns the growth period of each axis. `rest` is the rest shape of the plant.
std::vector<AxisAge> find_axis_ages(Plant const& plant, RestShape const& rest);

// Maturity, from 0 to 1, of a part that was born at the age `birth` (0 to kSkeletonShare), in a
// plant of the given age. At age 1 the maturity of all parts is 1.
inline double maturity(double age, double birth)
{
    return std::clamp((age - birth) / (1 - birth), 0.0, 1.0);
}

// How far an organ born at the age `birth` has unfolded, from 0 to 1. Unfolding takes 1 -
// kSkeletonShare of the plant's age, and starts and ends smoothly.
inline double unfolded(double age, double birth)
{
    double const t = std::clamp((age - birth) / (1 - kSkeletonShare), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

} // namespace tractus::variation
