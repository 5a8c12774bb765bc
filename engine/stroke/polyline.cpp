#include "engine/stroke/polyline.h"

#include <fmt/format.h>

namespace tractus {

Result<std::vector<Vec3>> distinct_points(std::span<Vec3 const> points)
{
    std::vector<Vec3> distinct;
    distinct.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite())
            return fail(Fault::User,
                        fmt::format("point {} of the stroke's {} is not a number: draw it again",
                                    i + 1, points.size()));
        if (distinct.empty() || points[i] != distinct.back())
            distinct.push_back(points[i]);
    }
    if (distinct.size() < 2)
        return fail(Fault::User,
                    fmt::format("the stroke's {} points all lie in one place: draw a longer stroke",
                                points.size()));
    return distinct;
}

Result<std::vector<Vec3>> stroke_points(Stroke const& stroke)
{
    std::vector<Vec3> points;
    points.reserve(stroke.tips.size());
    for (auto const& tip : stroke.tips)
        points.push_back(tip.position_mm);
    return distinct_points(points);
}

double polyline_length_mm(std::span<Vec3 const> points)
{
    double length_mm = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length_mm += (points[i] - points[i - 1]).norm();
    return length_mm;
}

} // namespace tractus
