#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus {

// A polyline parametrised by arc length. Repeated points are allowed.
class ArcLength {
public:
    // `points`: at least one, all finite.
    explicit ArcLength(std::span<Vec3 const> points);

    std::span<Vec3 const> points() const { return points_; }
    double length_mm() const { return length_to_mm_.back(); }

    // Returns the point at `fraction` of the length, from 0 (first point) to 1 (last point),
    // clamped to this range; the first point if the polyline has no length. Constant time on
    // average.
    Vec3 at(double fraction) const;

private:
    std::vector<Vec3> points_;
    std::vector<double> length_to_mm_; // Arc length from the first point to each point.

    // Lookup table: the length is divided into as many equal shares as there are points; for each
    // share, the index of the last point before it begins.
    std::vector<std::uint32_t> first_in_share_;
};

// Returns `count` points (at least 2) at equal arc-length distances along `points`, including both
// ends.
std::vector<Vec3> resample(std::span<Vec3 const> points, std::size_t count);

} // namespace tractus
