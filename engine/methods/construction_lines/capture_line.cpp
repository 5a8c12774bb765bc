#include "engine/methods/construction_lines/capture_line.h"

#include "engine/stroke/bspline.h"
#include "engine/stroke/resample.h"
#include "engine/stroke/subdivision.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tractus::lines {

std::vector<Vec3> capture_line(std::span<Vec3 const> tips)
{
    constexpr double kSpacing_mm = 0.5;
    constexpr std::size_t kMinControlPoints = 3;
    // Maximum number of control points, enough for a line of 4 m; longer lines are captured more
    // coarsely.
    constexpr std::size_t kMaxControlPoints = 1'000;
    // One round of reverse subdivision reduces 2n - 2 points to n, so three rounds reduce 8n - 14
    // points to n.
    double const wanted = (ArcLength(tips).length_mm() / kSpacing_mm + 15) / 8;
    auto const control_count = static_cast<std::size_t>(
        std::clamp<double>(std::ceil(wanted), kMinControlPoints, kMaxControlPoints));
    auto control = resample(tips, 8 * control_count - 14);
    for (int round = 0; round < 3; ++round)
        control = reverse_subdivide(control);
    return bspline_points(control, 8 * control_count - 14, { .degree = 2 });
}

} // namespace tractus::lines
