#include "engine/methods/leaves/leaf_cutout.h"

#include "engine/methods/leaves/flat_geometry.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tractus::leaf {

namespace {

// True if the segments from a to b and from c to d cross at inner points of both.
bool do_cross(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

// Returns the corners of the square blocks of pixels at the edge of the visible area; y is upwards.
std::vector<Vec2> edge_points(std::span<float const> alpha, int side, float least)
{
    int const block = std::max(1, side / 128);
    int const count = (side + block - 1) / block;
    std::vector<std::uint8_t> is_full(static_cast<std::size_t>(count * count));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            if (alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(side)
                      + static_cast<std::size_t>(x)]
                > least)
                is_full[static_cast<std::size_t>(y / block * count + x / block)] = 1;
    auto const full = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < count && y < count
            && is_full[static_cast<std::size_t>(y * count + x)] != 0;
    };
    std::vector<Vec2> points;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            if (!full(x, y)
                || (full(x - 1, y) && full(x + 1, y) && full(x, y - 1) && full(x, y + 1)))
                continue;
            for (int const i : { x * block, std::min(side, (x + 1) * block) })
                for (int const j : { y * block, std::min(side, (y + 1) * block) })
                    points.emplace_back(i, side - j);
        }
    return points;
}

// Convex hull, counter-clockwise (Andrew, "Another efficient algorithm for convex hulls in two
// dimensions", 1979).
std::vector<Vec2> convex_hull(std::vector<Vec2> points)
{
    auto const is_before = [](Vec2 const& a, Vec2 const& b) {
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    };
    std::ranges::sort(points, is_before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Vec2> hull;
    for (int const half : { 0, 1 }) {
        auto const begin = hull.size();
        for (auto const& point : points) {
            while (hull.size() >= begin + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
                hull.pop_back();
            hull.push_back(point);
        }
        hull.pop_back(); // The last point is also the first point of the other half.
        if (half == 0)
            std::ranges::reverse(points);
    }
    return hull;
}

class Shaper {
public:
    Shaper(std::vector<Vec2> points, int side)
        : points_(std::move(points))
        , side_(side)
        , corners_(convex_hull(points_))
    {
    }

    std::vector<Vec2> shape(CutoutOptions const& options)
    {
        double const least = 0.004 * side_ * side_;
        for (int i = 0; i < options.most_bays; ++i)
            if (!cut_bay(least))
                break;
        while (corners_.size() > static_cast<std::size_t>(std::max(4, options.most_corners)))
            if (!leave_side_out())
                break;
        return std::move(corners_);
    }

private:
    Vec2 const& corner(std::size_t i) const { return corners_[i % corners_.size()]; }

    struct Bay {
        // Index of the corner before the new corner; if a side is removed, of the side's first
        // corner.
        std::size_t behind = 0;
        Vec2 at = Vec2::Zero();
        double area = 0;
    };

    bool cut_bay(double min_area)
    {
        Bay best { .area = min_area };
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (auto const bay = bay_on(i); bay && bay->area > best.area)
                best = *bay;
        if (best.area <= min_area)
            return false;
        corners_.insert(corners_.begin() + static_cast<std::ptrdiff_t>(best.behind) + 1, best.at);
        return true;
    }

    // Cotangents of the angles, at the start and at the end of a side of the polygon, between the
    // side and the direction to a point.
    struct Seen {
        double from_start = 0;
        double from_end = 0;
    };
    std::vector<Seen> seen_from(Vec2 const& a, Vec2 const& b) const
    {
        Vec2 const along = (b - a).normalized();
        std::vector<Seen> seen;
        auto const add = [&](Vec2 const& point) {
            Vec2 const from_a = point - a;
            Vec2 const from_b = point - b;
            double const height = cross(along, from_a);
            if (from_a.squaredNorm() < 1e-9 || from_b.squaredNorm() < 1e-9)
                return;
            double const low = std::max(height, 1e-9);
            seen.push_back({ from_a.dot(along) / low, -from_b.dot(along) / low });
        };
        for (auto const& point : points_)
            add(point);
        for (auto const& point : corners_)
            add(point);
        return seen;
    }

    // Finds the largest triangle on a side of the polygon that contains no part of the leaf.
    std::optional<Bay> bay_on(std::size_t i) const
    {
        Vec2 const& a = corner(i);
        Vec2 const& b = corner(i + 1);
        double const length = (b - a).norm();
        auto seen = seen_from(a, b);
        std::ranges::sort(seen, std::ranges::greater(), &Seen::from_start);
        // Points are visited in ascending order of their angle at the side's start. The triangle's
        // angle at the side's end must not exceed the angle of any visited point there.
        double steepest = -std::numeric_limits<double>::infinity();
        Bay best { .behind = i };
        for (auto const& [from_start, from_end] : seen) {
            double const height = length / (from_start + steepest);
            double const area = 0.5 * length * height;
            if (from_start + steepest > 1e-6 && area > best.area) {
                Vec2 const along = (b - a) / length;
                Vec2 const at = a + height * (from_start * along + Vec2(-along.y(), along.x()));
                if (!crosses_others(i, at))
                    best = { .behind = i, .at = at, .area = area };
            }
            steepest = std::max(steepest, from_end);
        }
        if (best.area <= 0)
            return std::nullopt;
        return best;
    }

    bool crosses_others(std::size_t i, Vec2 const& at) const
    {
        for (std::size_t j = 0; j < corners_.size(); ++j)
            if (j != i
                && (do_cross(corner(i), at, corner(j), corner(j + 1))
                    || do_cross(at, corner(i + 1), corner(j), corner(j + 1))))
                return true;
        return false;
    }

    // Removes the side whose removal adds least area to the polygon. The intersection of its two
    // extended neighbours replaces it.
    bool leave_side_out()
    {
        std::optional<Bay> best;
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (auto const peak = peak_over(i); peak && (!best || peak->area < best->area))
                best = peak;
        if (!best)
            return false;
        corners_[best->behind] = best->at;
        corners_.erase(corners_.begin()
                       + static_cast<std::ptrdiff_t>((best->behind + 1) % corners_.size()));
        return true;
    }

    std::optional<Bay> peak_over(std::size_t i) const
    {
        auto const count = corners_.size();
        Vec2 const& a = corner(i);
        Vec2 const& b = corner(i + 1);
        Vec2 const in = a - corner(i + count - 1);
        Vec2 const out = b - corner(i + 2);
        double const across = cross(in, out);
        if (cross(in, b - a) <= 0 || turn(a, b, corner(i + 2)) <= 0 || across >= 0)
            return std::nullopt;
        double const far = cross(b - a, out) / across;
        Vec2 const at = a + far * in;
        bool const is_inside
            = at.x() >= 0 && at.y() >= 0 && at.x() <= side_ && at.y() <= side_ && far > 0;
        if (!is_inside || crosses_others(i, at))
            return std::nullopt;
        return Bay { .behind = i, .at = at, .area = 0.5 * std::abs(turn(a, at, b)) };
    }

    std::vector<Vec2> points_;
    double side_;
    std::vector<Vec2> corners_; // Corners of the polygon, counter-clockwise, y upwards.
};

} // namespace

Cutout cut_out(std::span<float const> alpha, int side, CutoutOptions const& options)
{
    Cutout made;
    auto points = edge_points(alpha, side, options.min_alpha);
    if (points.empty())
        return made;
    made.corners = Shaper(std::move(points), side).shape(options);
    made.triangles = cut_polygon(made.corners);
    for (auto& corner : made.corners)
        corner.y() = side - corner.y();
    return made;
}

} // namespace tractus::leaf
