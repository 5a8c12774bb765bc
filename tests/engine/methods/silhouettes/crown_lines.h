#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/silhouettes/crown_line.h"

#include <cmath>

// Lines on crowns of known shape, in millimetres. The trunk is at x = 0.
namespace tractus::silhouette::crown_lines {

// Returns an ellipse with half-axes a and b at the given height, traversed `turns` times.
inline CrownLine ring(double a, double b, double height, double turns = 1)
{
    constexpr int kPoints = 200;
    CrownLine line;
    for (int i = 0; i < kPoints; ++i) {
        double const angle = 0.3 + 2 * kPi * turns * i / kPoints;
        line.emplace_back(a * std::cos(angle), height, b * std::sin(angle));
    }
    return line;
}

// Returns the radius of a cone at a height. The cone reaches from 30 to 120 mm and has a radius of
// 40 mm at its base.
inline double cone_radius(double height)
{
    return 40 * (120 - height) / 90;
}

inline CrownLine cone_climb(double turns)
{
    CrownLine line;
    int const points = 240 * static_cast<int>(std::ceil(turns));
    for (int i = 0; i <= points; ++i) {
        double const share = static_cast<double>(i) / points;
        double const height = 30 + 88 * share;
        double const angle = 2 * kPi * turns * share;
        line.emplace_back(cone_radius(height) * std::cos(angle), height,
                          cone_radius(height) * std::sin(angle));
    }
    return line;
}

// Returns an ellipse in the vertical plane with the given azimuth.
inline CrownLine side(double azimuth_deg, double half_width, double half_height, double middle)
{
    constexpr int kPoints = 200;
    CrownLine line;
    for (int i = 0; i <= kPoints; ++i) {
        double const angle = 2 * kPi * i / kPoints;
        double const out = half_width * std::cos(angle);
        line.emplace_back(out * std::cos(radians(azimuth_deg)),
                          middle + half_height * std::sin(angle),
                          out * std::sin(radians(azimuth_deg)));
    }
    return line;
}

} // namespace tractus::silhouette::crown_lines
