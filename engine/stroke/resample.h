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

    // Returns the point at `fraction` of the polyline's length. `fraction` is clamped to 0 (first
    // point) to 1 (last point). If the polyline has no length, returns the first point. Constant
    // time on average.
    Vec3 at(double fraction) const;

private:
    std::vector<Vec3> points_;
    std::vector<double> length_to_mm_; // Arc length from the first point to each point.

    // Lookup table. The polyline's length is divided into as many equal shares as there are points;
    // the entry of a share is the index of the last point before the share begins.
    std::vector<std::uint32_t> first_in_share_;
};

// Returns `count` points (at least 2) along the polyline `points`, at equal distances in arc length
// and including both ends.
std::vector<Vec3> resample(std::span<Vec3 const> points, std::size_t count);

} // namespace tractus
