#include "engine/stroke/bspline.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>

namespace tractus {

// Returns the value of knot i, in units of one span. Clamped knots repeat the values at both ends;
// uniform knots continue beyond them.
static double knot(int i, int degree, int spans, BSplineOptions::Ends ends)
{
    int const value = i - degree;
    return ends == BSplineOptions::Ends::Clamped ? std::clamp(value, 0, spans) : value;
}

Vec3 bspline_point(std::span<Vec3 const> control, double t, BSplineOptions const& options)
{
    CHECK(!control.empty());
    CHECK(options.degree == 2 || options.degree == 3);
    int const count = static_cast<int>(control.size());
    int const degree = std::min(options.degree, count - 1);
    if (degree == 0)
        return control[0];

    int const spans = count - degree;
    double const u = std::clamp(t, 0.0, 1.0) * spans;
    int const span = std::min(static_cast<int>(u), spans - 1);

    std::array<Vec3, 4> point;
    for (int j = 0; j <= degree; ++j)
        point[static_cast<std::size_t>(j)] = control[static_cast<std::size_t>(span + j)];
    for (int round = 1; round <= degree; ++round) {
        for (int j = degree; j >= round; --j) {
            double const low = knot(span + j, degree, spans, options.ends);
            double const high = knot(span + j + degree + 1 - round, degree, spans, options.ends);
            double const share = (u - low) / (high - low);
            auto const at = static_cast<std::size_t>(j);
            point[at] = (1 - share) * point[at - 1] + share * point[at];
        }
    }
    return point[static_cast<std::size_t>(degree)];
}

std::vector<Vec3> bspline_points(std::span<Vec3 const> control, std::size_t count,
                                 BSplineOptions const& options)
{
    CHECK(count >= 2);
    std::vector<Vec3> points(count);
    for (std::size_t i = 0; i < count; ++i)
        points[i] = bspline_point(control, static_cast<double>(i) / static_cast<double>(count - 1),
                                  options);
    return points;
}

} // namespace tractus
