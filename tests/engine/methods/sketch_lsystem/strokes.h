#pragma once

#include "engine/base/vectors.h"

#include <cmath>
#include <vector>

namespace tractus::sketch {

inline std::vector<Vec3> straight_stroke(double length_mm, int pieces = 1000)
{
    std::vector<Vec3> tips;
    for (int i = 0; i <= pieces; ++i)
        tips.emplace_back(0, 0, length_mm * i / pieces);
    return tips;
}

// Returns a half circle from the origin upwards and over to the right.
inline std::vector<Vec3> half_circle(double radius_mm, int pieces = 20'000)
{
    std::vector<Vec3> tips;
    for (int i = 0; i <= pieces; ++i) {
        double const angle = kPi * i / pieces;
        tips.emplace_back(radius_mm - radius_mm * std::cos(angle), 0, radius_mm * std::sin(angle));
    }
    return tips;
}

// Returns a polyline through corners, with fifty pieces from each corner to the next.
inline std::vector<Vec3> polyline(std::vector<Vec3> const& corners)
{
    std::vector<Vec3> tips;
    for (std::size_t i = 1; i < corners.size(); ++i)
        for (int j = 0; j <= 50; ++j)
            tips.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * (j / 50.0));
    return tips;
}

// Returns a stroke that leads up, then to the right, and then towards the user.
inline std::vector<Vec3> corner_in_space()
{
    return polyline({ { 0, 0, 0 }, { 0, 0, 30 }, { 30, 0, 30 }, { 30, -30, 30 } });
}

// Returns a stroke that curves in all directions of space.
inline std::vector<Vec3> bow(int tips_count = 150)
{
    std::vector<Vec3> tips;
    for (int i = 0; i < tips_count; ++i)
        tips.emplace_back(60 * std::sin(.02 * i), 12 * std::sin(.04 * i), 1.3 * i);
    return tips;
}

} // namespace tractus::sketch
