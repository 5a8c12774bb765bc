#pragma once

#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus {

// A polyline that is asked for its point at a share of its length. Repeated points do no harm.
class ArcLength {
public:
    // Measures at least one point, all finite.
    explicit ArcLength(std::span<Vec3 const> points);

    std::span<Vec3 const> points() const { return points_; }
    double length_mm() const { return length_to_mm_.back(); }

    // The point at `fraction` of the length, 0 the first point and 1 the last; outside of that the
    // nearest end. Where all points are equal: that point. In the mean in constant time.
    Vec3 at(double fraction) const;

private:
    std::vector<Vec3> points_;
    std::vector<double> length_to_mm_; // Along the polyline to each point.

    // Last point before each share of the length begins; there are as many equal shares as points.
    std::vector<std::uint32_t> first_in_share_;
};

// `count` points (at least 2) at equal distances along `points`, both ends among them.
std::vector<Vec3> resample(std::span<Vec3 const> points, std::size_t count);

} // namespace tractus
