#include "engine/methods/silhouettes/plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::silhouette {

Vec2 turned(Vec2 const& v, double angle_rad)
{
    double const c = std::cos(angle_rad);
    double const s = std::sin(angle_rad);
    return { c * v.x() - s * v.y(), s * v.x() + c * v.y() };
}

Vec2 direction_of(Vec2 const& v, Vec2 const& otherwise)
{
    double const length = v.norm();
    return length > 0 ? Vec2(v / length) : otherwise;
}

double signed_area(std::span<Vec2 const> outline)
{
    double twice = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        twice += cross(outline[i], outline[(i + 1) % outline.size()]);
    return twice / 2;
}

bool is_inside(std::span<Vec2 const> outline, Vec2 const& point)
{
    bool inside = false;
    auto const* before = &outline.back();
    for (auto const& corner : outline) {
        auto const& a = *before;
        auto const& b = corner;
        if ((a.y() <= point.y()) != (b.y() <= point.y())
            && a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > point.x())
            inside = !inside;
        before = &corner;
    }
    return inside;
}

double distance_to_segment(Vec2 const& point, Vec2 const& a, Vec2 const& b)
{
    Vec2 const along = b - a;
    double const share
        = std::clamp((point - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
    return (a + share * along - point).norm();
}

double distance_to_line(Vec2 const& point, std::span<Vec2 const> line)
{
    double least = (point - line.front()).norm();
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distance_to_segment(point, line[i - 1], line[i]));
    return least;
}

double distance_to_outline(std::span<Vec2 const> outline, Vec2 const& point)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i)
        least = std::min(least,
                         distance_to_segment(point, outline[i], outline[(i + 1) % outline.size()]));
    return least;
}

std::optional<double> ray_distance_to_outline(std::span<Vec2 const> outline, Vec2 const& from,
                                              Vec2 const& ahead)
{
    std::optional<double> least;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Vec2 const edge = outline[(i + 1) % outline.size()] - outline[i];
        Vec2 const to = outline[i] - from;
        double const across = cross(ahead, edge);
        double const far = cross(to, edge) / across;
        double const along = cross(to, ahead) / across;
        if (across != 0 && far > 0 && along >= 0 && along <= 1 && (!least || far < *least))
            least = far;
    }
    return least;
}

double excursion(std::span<Vec2 const> outline, std::span<Vec2 const> points)
{
    double farthest = 0;
    for (auto const& point : points)
        if (!is_inside(outline, point))
            farthest = std::max(farthest, distance_to_outline(outline, point));
    return farthest;
}

bool do_cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    return cross(b - a, c - a) * cross(b - a, d - a) < 0
        && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

Box box_of(std::span<Vec2 const> points)
{
    Box box { points.front(), points.front() };
    for (auto const& point : points) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return box;
}

double length_of(std::span<Vec2 const> points)
{
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return length;
}

// Points at the arc lengths i * step, i from 0 to count - 1.
static std::vector<Vec2> points_along(std::span<Vec2 const> points, std::size_t count, double step)
{
    std::vector<Vec2> result;
    result.reserve(count);
    std::size_t next = 1;
    double passed = 0;
    for (std::size_t i = 0; i < count; ++i) {
        double const at = step * static_cast<double>(i);
        while (next + 1 < points.size() && passed + (points[next] - points[next - 1]).norm() < at)
            passed += (points[next] - points[next - 1]).norm(), ++next;
        if (next >= points.size()) {
            result.push_back(points.back());
            continue;
        }
        double const piece = (points[next] - points[next - 1]).norm();
        double const share = piece > 0 ? std::clamp((at - passed) / piece, 0.0, 1.0) : 0;
        result.emplace_back(points[next - 1] + share * (points[next] - points[next - 1]));
    }
    return result;
}

std::vector<Vec2> resampled_line(std::span<Vec2 const> points, std::size_t count)
{
    auto result = points_along(points, count, length_of(points) / static_cast<double>(count - 1));
    result.back() = points.back();
    return result;
}

std::vector<Vec2> resampled_outline(std::span<Vec2 const> points, std::size_t count)
{
    std::vector<Vec2> closed(points.begin(), points.end());
    closed.push_back(points.front());
    return points_along(closed, count, length_of(closed) / static_cast<double>(count));
}

Vec2 Cubic::at(double x) const
{
    double const x2 = x * x;
    double const x3 = x2 * x;
    return (2 * x3 - 3 * x2 + 1) * base + (x3 - 2 * x2 + x) * base_tangent + (3 * x2 - 2 * x3) * end
        + (x3 - x2) * end_tangent;
}

std::vector<Vec2> Cubic::points(std::size_t count) const
{
    std::vector<Vec2> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        result.push_back(at(static_cast<double>(i) / static_cast<double>(count - 1)));
    return result;
}

std::vector<Vec2> Similarity::points(std::span<Vec2 const> line) const
{
    std::vector<Vec2> result;
    result.reserve(line.size());
    for (auto const& p : line)
        result.push_back(point(p));
    return result;
}

Cubic Similarity::cubic(Cubic const& curve) const
{
    return { point(curve.base), point(curve.end), vector(curve.base_tangent),
             vector(curve.end_tangent) };
}

Vec2 turn_between(Vec2 const& from, Vec2 const& to, bool mirrors)
{
    double const y = mirrors ? from.y() : -from.y();
    return { to.x() * from.x() - to.y() * y, to.x() * y + to.y() * from.x() };
}

} // namespace tractus::silhouette
