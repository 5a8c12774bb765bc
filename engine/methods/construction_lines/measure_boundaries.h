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

// Returns a line's points without points that coincide with the one before. Fails with a user
// error, saying what to draw, if fewer than two points are left, or if a coordinate exceeds
// kFarthest_mm.
template<typename Point>
Result<std::vector<Point>> line_points(std::vector<Point> const& points, std::string const& name,
                                       char const* what_to_draw)
{
    constexpr double kFarthest_mm = 1e5;
    for (auto const& point : points)
        // The negated condition is also true for NaN.
        if (!(point.array().abs() <= kFarthest_mm).all())
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

// A boundary in space, and its azimuth around the stem.
struct AroundLine {
    std::vector<Vec3> points;
    double azimuth_deg = 0;
};

// The boundaries of a sketch: on the sheet at the stem's left and right, and in space. A boundary
// on the sheet may be missing only if there are boundaries in space.
struct Boundaries {
    std::optional<DrawnLine> left;
    std::optional<DrawnLine> right;
    std::vector<AroundLine> around {};

    std::optional<DrawnLine> const& of(Side side) const
    {
        return side == Side::Left ? left : right;
    }
};

// Finds the boundaries of a sketch, with those in space in ascending azimuths. Boundaries that are
// missing or misplaced are reported in `notes`. Fails with a user error if the sketch has no
// boundary, or if boundaries run along the stem itself or beside each other.
Result<Boundaries> measure_boundaries(LineSketch const& sketch, DrawnStem const& stem,
                                      std::vector<std::string>& notes);

// Returns the boundary that inclination lines meet on a side of the stem: the one on the sheet, or
// else the projection of the nearest boundary in space.
std::optional<DrawnLine> seen_on_side(Boundaries const& boundaries, Side side);

} // namespace tractus::lines
