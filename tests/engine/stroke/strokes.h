#pragma once

#include "engine/base/random.h"
#include "engine/stroke/stroke.h"

#include <cstdint>
#include <vector>

namespace tractus {

// Returns a stroke through `points`, in millimetres, with 5 ms between successive tips.
inline Stroke stroke_of(std::vector<Vec3> const& points)
{
    Stroke stroke;
    for (std::size_t i = 0; i < points.size(); ++i)
        stroke.tips.push_back({ .time = timestamp_ns(static_cast<std::int64_t>(i) * 5'000'000),
                                .position_mm = points[i],
                                .pressure = 0.5,
                                .touching = true });
    return stroke;
}

// Returns the points of a gentle S of about 300 mm that starts upwards.
inline std::vector<Vec3> s_curve(int points)
{
    std::vector<Vec3> curve;
    for (int i = 0; i < points; ++i) {
        double const t = i / (points - 1.0);
        curve.push_back({ 60 * std::sin(2 * kPi * t) * t * t, 40 * t * t * t, 280 * t });
    }
    return curve;
}

// Returns `points` with the tremor of a hand: normal random numbers with the standard deviation
// `tremor_mm` are added to all coordinates.
inline std::vector<Vec3> trembling(std::vector<Vec3> points, double tremor_mm,
                                   std::uint64_t seed = 11)
{
    Random random({ .seed = seed });
    for (auto& point : points)
        for (double& coordinate : point)
            coordinate += tremor_mm * random.normal();
    return points;
}

} // namespace tractus
