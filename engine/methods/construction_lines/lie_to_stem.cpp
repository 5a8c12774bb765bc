#include "engine/methods/construction_lines/lie_to_stem.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace tractus::lines {

namespace {

// Tolerances for strokes on a sheet of paper. A point within kNoSide_mm of the stem is on neither
// side of it.
constexpr double kNoSide_mm = 1.5;
constexpr double kEachSide_mm = 3; // Minimum reach of an inclination line on each side.
// Maximum distance from the stem at which half an inclination line begins.
constexpr double kFromStem_mm = 5;
constexpr double kGraze_mm = 10; // Maximum distance to which a boundary may reach across the stem.
// Length of a stroke, as a share of the stem's, up to which half an inclination line may have any
// lean.
constexpr double kLongHalf = 0.6;
constexpr double kLeaning_deg = 20; // Minimum lean of longer half lines relative to the stem.
constexpr double kBoundary = 0.4;   // Minimum share of the stem along which a boundary runs.
// Maximum share of the stem along which half an inclination line may run.
constexpr double kWholeStem = 0.75;

double lean_between(DrawnLine const& a, DrawnLine const& b)
{
    Vec2 const chord = a.points().back() - a.points().front();
    Vec2 const other = b.points().back() - b.points().front();
    return degrees(std::atan2(std::fabs(cross(chord, other)), std::fabs(chord.dot(other))));
}

} // namespace

Lie lie_of(DrawnLine const& stroke, DrawnLine const& stem)
{
    Lie lie;
    double nearest = stem.length_mm();
    double farthest = 0;
    // Signed distance from the stem of the last point that was clearly on one side, more than
    // kNoSide_mm away.
    double before_mm = 0;
    double left = 0;
    double reach_left_mm = 0;
    double reach_right_mm = 0;
    // True if that point or a later one was beside the stem, not beyond its ends.
    bool beside = false;
    for (auto const& point : stroke.points()) {
        double const at_mm = stem.nearest_mm(point);
        double const distance_mm = stem.distance_mm(point);
        nearest = std::min(nearest, at_mm);
        farthest = std::max(farthest, at_mm);
        left += distance_mm > 0 ? 1 : 0;
        reach_left_mm = std::max(reach_left_mm, distance_mm);
        reach_right_mm = std::max(reach_right_mm, -distance_mm);
        beside = beside || (at_mm > 0 && at_mm < stem.length_mm());
        if (std::fabs(distance_mm) < kNoSide_mm)
            continue;
        if (distance_mm * before_mm < 0 && beside)
            ++lie.crossings;
        before_mm = distance_mm;
        beside = at_mm > 0 && at_mm < stem.length_mm();
    }
    lie.first_mm = stem.distance_mm(stroke.points().front());
    lie.last_mm = stem.distance_mm(stroke.points().back());
    lie.along = std::max(0.0, farthest - nearest) / stem.length_mm();
    lie.left_share = left / static_cast<double>(stroke.points().size());
    lie.min_side_mm = lie.left_share > 0.5 ? reach_right_mm : reach_left_mm;
    lie.lean_deg = lean_between(stroke, stem);
    return lie;
}

bool is_inclination(Lie const& lie)
{
    return lie.crossings == 1 && lie.first_mm * lie.last_mm < 0
        && std::min(std::fabs(lie.first_mm), std::fabs(lie.last_mm)) > kEachSide_mm;
}

// A boundary may cross the stem slightly at the stem's top or foot; an inclination line that does
// so leans more.
bool is_boundary(Lie const& lie)
{
    bool const grazes = lie.crossings <= 2 && lie.min_side_mm < kGraze_mm
        && (lie.lean_deg < kLeaning_deg || lie.along > kWholeStem);
    return lie.along > kBoundary && (lie.crossings == 0 || grazes);
}

// Half an inclination line begins near the stem or just behind it, and ends away from it.
bool is_half(Lie const& lie, double length)
{
    double const near_mm = std::min(std::fabs(lie.first_mm), std::fabs(lie.last_mm));
    double const far_mm = std::max(std::fabs(lie.first_mm), std::fabs(lie.last_mm));
    bool const begins_at_stem = lie.crossings == 0 ? near_mm <= kFromStem_mm
                                                   : lie.crossings == 1 && near_mm <= kEachSide_mm;
    return begins_at_stem && far_mm > kFromStem_mm && lie.along < kWholeStem
        && (length < kLongHalf || lie.lean_deg > kLeaning_deg);
}

// A boundary in front of the stem or behind it may appear to cross the stem.
bool is_boundary_in_space(Lie const& lie)
{
    bool const is_across = is_inclination(lie) && lie.lean_deg > kLeaning_deg;
    bool const is_beside = lie.crossings == 0 || lie.lean_deg < kLeaning_deg;
    return !is_across && (is_along_stem(lie) || (lie.along > kBoundary && is_beside));
}

bool is_along_stem(Lie const& lie)
{
    return lie.along > kWholeStem;
}

std::string explain_no_role(Lie const& lie)
{
    if (lie.crossings > 1)
        return fmt::format(
            "this line crosses the stem {} times: draw an inclination line across it "
            "once, or a boundary beside it",
            lie.crossings);
    if (lie.crossings == 1)
        return "this line hardly reaches over the stem: draw an inclination line that ends on both "
               "sides of it";
    return "this line neither crosses the stem nor goes along it: draw an inclination line across "
           "it, or a boundary along at least half of it";
}

} // namespace tractus::lines
