#include "engine/methods/construction_lines/measure_boundaries.h"

#include "engine/methods/construction_lines/around_stem.h"

#include <algorithm>
#include <cstddef>

namespace tractus::lines {

namespace {

// Returns the boundaries in space, sorted by azimuth.
Result<std::vector<AroundLine>> measure_around(LineSketch const& sketch, DrawnStem const& stem)
{
    std::vector<AroundLine> result;
    for (auto const& line : sketch.around) {
        auto const name = fmt::format("boundary {} in space", result.size() + 1);
        auto points = TRY(line_points(line, name, "the line that the organs' tips reach there"));
        auto const azimuth_deg = azimuth_of(points, stem);
        if (!azimuth_deg)
            return fail(Fault::User,
                        fmt::format("{} goes along the stem or around it: draw it on one side of "
                                    "the stem",
                                    name));
        result.push_back({ std::move(points), *azimuth_deg });
    }
    std::sort(result.begin(), result.end(), [](AroundLine const& a, AroundLine const& b) {
        return a.azimuth_deg < b.azimuth_deg;
    });
    return result;
}

Result<void> check_azimuths_apart(Boundaries const& boundaries)
{
    std::vector<double> azimuths;
    for (auto const side : { Side::Left, Side::Right })
        if (boundaries.of(side))
            azimuths.push_back(azimuth_of_side(side));
    for (auto const& line : boundaries.around) {
        for (auto const other_deg : azimuths)
            if (degrees_between(line.azimuth_deg, other_deg) < kSameAzimuth_deg)
                return fail(Fault::User,
                            fmt::format("two boundaries are on the same side of the stem, {:.0f} "
                                        "degrees around it from its left: leave one of them out",
                                        line.azimuth_deg));
        azimuths.push_back(line.azimuth_deg);
    }
    return {};
}

std::vector<Vec2> laid_flat(std::vector<Vec3> const& points)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.emplace_back(point.head<2>());
    return result;
}

// Moves boundaries in space onto the sheet if the sketch has no boundaries other than one on the
// left and one on the right in space.
void lay_on_sheet(LineSketch const& sketch, std::vector<AroundLine>& around,
                  std::vector<Vec2>& left, std::vector<Vec2>& right)
{
    auto const is_at = [](AroundLine const& line, Side side) {
        return degrees_between(line.azimuth_deg, azimuth_of_side(side)) < kSameAzimuth_deg;
    };
    auto const count_at = [&](Side side) {
        return std::count_if(around.begin(), around.end(),
                             [&](AroundLine const& line) { return is_at(line, side); });
    };
    auto const lefts = count_at(Side::Left);
    auto const rights = count_at(Side::Right);
    if (lefts + rights != static_cast<std::ptrdiff_t>(around.size())
        || lefts + (sketch.left.empty() ? 0 : 1) > 1 || rights + (sketch.right.empty() ? 0 : 1) > 1)
        return;
    for (auto const& line : around)
        (is_at(line, Side::Left) ? left : right) = laid_flat(line.points);
    around.clear();
}

} // namespace

Result<Boundaries> measure_boundaries(LineSketch const& sketch, DrawnStem const& stem,
                                      std::vector<std::string>& notes)
{
    // A side needs no boundary on the sheet if a boundary in space is within this angle of it.
    constexpr double kSameSide_deg = 60;
    if (!has_boundary(sketch))
        return fail(Fault::User,
                    "there is no boundary: draw the line that the organs' tips reach, "
                    "on the left and on the right of the stem");
    Boundaries result { std::nullopt, std::nullopt, TRY(measure_around(sketch, stem)) };
    auto left = sketch.left;
    auto right = sketch.right;
    lay_on_sheet(sketch, result.around, left, right);
    auto const is_beside = [&](Side side) {
        return std::any_of(result.around.begin(), result.around.end(), [&](AroundLine const& line) {
            return degrees_between(line.azimuth_deg, azimuth_of_side(side)) <= kSameSide_deg;
        });
    };
    auto const measure = [&](std::vector<Vec2> const& own, std::vector<Vec2> const& other,
                             Side side) -> Result<std::optional<DrawnLine>> {
        auto const name = fmt::format("the {} boundary", name_of_side(side));
        constexpr char const* kWhatToDraw = "the line that the organs' tips reach on this side";
        if (!own.empty())
            return std::optional(DrawnLine(TRY(line_points(own, name, kWhatToDraw))));
        if (!result.around.empty() && (other.empty() || is_beside(side)))
            return std::optional<DrawnLine>();
        notes.push_back(name + " is missing: it is the other one, mirrored");
        auto const points = TRY(line_points(other, "the only boundary", kWhatToDraw));
        auto const there = mirrored(stem.seen(), points);
        return std::optional(DrawnLine(TRY(line_points(there, name, kWhatToDraw))));
    };
    result.left = TRY(measure(left, right, Side::Left));
    result.right = TRY(measure(right, left, Side::Right));
    TRY(check_azimuths_apart(result));
    return result;
}

std::optional<DrawnLine> seen_on_side(Boundaries const& boundaries, Side side)
{
    // Maximum angle between a side and a boundary in space that is seen on that side.
    constexpr double kStillSeen_deg = 60;
    if (boundaries.of(side))
        return boundaries.of(side);
    AroundLine const* nearest = nullptr;
    double min_deg = kStillSeen_deg;
    for (auto const& line : boundaries.around) {
        double const off_deg = degrees_between(line.azimuth_deg, azimuth_of_side(side));
        if (off_deg <= min_deg) {
            min_deg = off_deg;
            nearest = &line;
        }
    }
    return nearest ? std::optional(DrawnLine(laid_flat(nearest->points))) : std::nullopt;
}

} // namespace tractus::lines
