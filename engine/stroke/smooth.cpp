#include "engine/stroke/smooth.h"

#include "engine/base/check.h"
#include "engine/stroke/resample.h"
#include "engine/stroke/subdivision.h"

namespace tractus {

// Number of control points that remain after reverse subdivision: enough for a helix of three
// turns.
constexpr std::size_t kControlPoints = 18;

std::vector<Vec3> smooth_hand_line(std::span<Vec3 const> points, double detail_weight)
{
    CHECK(points.size() >= 2);
    CHECK(detail_weight >= 0 && detail_weight <= 1);
    if (detail_weight == 1)
        return { points.begin(), points.end() };

    // A round takes n points to 2n - 2. Finds the number of rounds, at least one, that take
    // kControlPoints to at least as many points as were given.
    int rounds = 1;
    std::size_t count = 2 * kControlPoints - 2;
    for (; count < points.size(); ++rounds)
        count = 2 * count - 2;

    auto const drawn = resample(points, count);
    auto curve = drawn;
    for (int round = 0; round < rounds; ++round)
        curve = reverse_subdivide(curve);
    for (int round = 0; round < rounds; ++round)
        curve = subdivide(curve);
    for (std::size_t i = 0; i < curve.size(); ++i)
        curve[i] += detail_weight * (drawn[i] - curve[i]);
    return curve;
}

} // namespace tractus
