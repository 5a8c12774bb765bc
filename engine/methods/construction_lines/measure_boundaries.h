#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"
#include "engine/methods/construction_lines/measure_nodes.h"

#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// A line's points without repeated ones. Refuses, as the user's fault, one that has none or only
// one, saying what to draw, and one that is far away.
template<typename Point>
Result<std::vector<Point>> line_points(std::vector<Point> const& points, std::string const& name,
                                       char const* what_to_draw)
{
    constexpr double kFarthest_mm = 1e5;
    for (auto const& point : points)
        if (!(point.array().abs() <= kFarthest_mm).all()) // True for NaN.
            return fail(Fault::User,
                        fmt::format("{} has a point that is farther than {:g} mm away: give "
                                    "its points in millimetres",
                                    name, kFarthest_mm));
    auto result = without_repeats(points);
    if (result.size() < 2)
        return fail(Fault::User,
                    fmt::format("{} is missing or only a dot: draw {}", name, what_to_draw));
    return result;
}

// A boundary in space.
struct AroundLine {
    std::vector<Vec3> points;
    double azimuth_deg = 0;
};

// The boundaries of a sketch. On the sheet there is none on a side only where some are in space.
struct Boundaries {
    std::optional<DrawnLine> left;
    std::optional<DrawnLine> right;
    std::vector<AroundLine> around {};

    std::optional<DrawnLine> const& of(Side side) const
    {
        return side == Side::Left ? left : right;
    }
};

// The boundaries that a sketch has, the azimuths of those in space rising; what is missing or
// stands on its other side is noted. Refuses a sketch without any, and boundaries that go along the
// stem itself or beside each other.
Result<Boundaries> measure_boundaries(LineSketch const& sketch, DrawnStem const& stem,
                                      std::vector<std::string>& notes);

// What inclination lines meet on a side: the boundary there, or as it is seen the nearest one in
// space.
std::optional<DrawnLine> seen_on_side(Boundaries const& boundaries, Side side);

} // namespace tractus::lines
