#include "engine/methods/construction_lines/organ_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string_view>
#include <utility>

namespace tractus::lines {

namespace {

using Points = std::vector<Vec2>;
using Cubic = std::array<Vec2, 4>; // The four control points of a Bézier curve.

constexpr double kShortestOrgan_mm = 1e-3;

// Resamples a line at equal steps of arc length. Fails with a user error if the line has no length.
Result<Points> even_points(Points const& line, int pieces, char const* name)
{
    std::vector<double> lengths { 0 };
    for (std::size_t i = 1; i < line.size(); ++i)
        lengths.push_back(lengths.back() + (line[i] - line[i - 1]).norm());
    if (!(lengths.back() >= kShortestOrgan_mm) || !(lengths.back() < 1e6))
        return fail(Fault::User,
                    fmt::format("the organ's {} has no length: draw it from one end to the other, "
                                "in millimetres",
                                name));
    Points result;
    std::size_t at = 1;
    for (int i = 0; i <= pieces; ++i) {
        double const far = lengths.back() * i / pieces;
        while (at + 1 < line.size() && lengths[at] < far)
            ++at;
        double const piece = lengths[at] - lengths[at - 1];
        double const share = piece > 0 ? std::clamp((far - lengths[at - 1]) / piece, 0.0, 1.0) : 0;
        result.emplace_back(line[at - 1] + share * (line[at] - line[at - 1]));
    }
    return result;
}

// Catmull-Rom spline through points, as Bézier pieces; straight lines stay straight.
std::vector<Cubic> spline(Points const& points)
{
    auto const last = points.size() - 1;
    auto const slope = [&](std::size_t i) -> Vec2 {
        if (i == 0)
            return points[1] - points[0];
        if (i == last)
            return points[last] - points[last - 1];
        return (points[i + 1] - points[i - 1]) / 2;
    };
    std::vector<Cubic> pieces;
    for (std::size_t i = 0; i < last; ++i)
        pieces.push_back({ points[i], points[i] + slope(i) / 3, points[i + 1] - slope(i + 1) / 3,
                           points[i + 1] });
    return pieces;
}

// Converts a line that never turns back to heights above its chord, at equal steps along the chord.
// All coordinates are shares of the chord's length, so the result runs from (0, 0) to (1, 0).
Result<Points> heights_of(Points const& line, int pieces, char const* name)
{
    Points result;
    double const way = line.empty() ? 1 : line.back().x() - line.front().x();
    for (std::size_t i = 1; i < line.size(); ++i)
        if (!(line[i].x() * way >= line[i - 1].x() * way))
            return fail(Fault::User,
                        fmt::format("the organ's {} turns back at point {}: draw it so that it "
                                    "goes on from one end to the other",
                                    name, i + 1));
    if (!line.empty() && !(std::fabs(way) >= kShortestOrgan_mm))
        return fail(Fault::User,
                    fmt::format("the organ's {} has no length: draw it from one end to the other, "
                                "in millimetres",
                                name));
    std::size_t at = 1;
    for (int i = 0; i <= pieces; ++i) {
        double const share = static_cast<double>(i) / pieces;
        if (line.empty()) {
            result.emplace_back(share, 0);
            continue;
        }
        auto const share_of = [&](std::size_t k) { return (line[k].x() - line[0].x()) / way; };
        while (at + 1 < line.size() && share_of(at) < share)
            ++at;
        double const piece = share_of(at) - share_of(at - 1);
        double const part
            = piece > 0 ? std::clamp((share - share_of(at - 1)) / piece, 0.0, 1.0) : 1;
        double const height = line[at - 1].y() + part * (line[at].y() - line[at - 1].y());
        double const straight = line.front().y() + share * (line.back().y() - line.front().y());
        result.emplace_back(share, (height - straight) / std::fabs(way));
    }
    return result;
}

struct Sides {
    Points left;
    Points right;
    double length_mm = 0;
};

// Moves both boundaries so that the midpoint between their bases is at the origin and the midpoint
// between their tips is on the y axis.
Result<Sides> place_sides(OrganViews const& views)
{
    Sides sides { TRY(even_points(views.left, kAlong, "left boundary")),
                  TRY(even_points(views.right, kAlong, "right boundary")) };
    auto& right = sides.right;
    Vec2 const base = (sides.left.front() + right.front()) / 2;
    Vec2 const axis = (sides.left.back() + right.back()) / 2 - base;
    sides.length_mm = axis.norm();
    if (!(sides.length_mm >= kShortestOrgan_mm))
        return fail(Fault::User,
                    "the organ's boundaries end where they begin: draw both from its base to its "
                    "tip");
    Vec2 const up = axis / sides.length_mm;
    for (auto* const line : { &sides.left, &right })
        for (auto& point : *line) {
            Vec2 const from_base = point - base;
            point = { from_base.x() * up.y() - from_base.y() * up.x(), from_base.dot(up) };
        }
    return sides;
}

// Adds a missing boundary, and reverses the right one if necessary, so that both run from base to
// tip.
OrganViews with_both(OrganViews views)
{
    if (views.left.empty())
        views.left = mirrored(views.right);
    auto& left = views.left;
    auto& right = views.right;
    if (right.empty())
        right = mirrored(left);
    bool const is_reversed = !left.empty()
        && (right.back() - left.front()).norm() < (right.front() - left.front()).norm();
    if (is_reversed)
        std::reverse(right.begin(), right.end());
    return views;
}

Result<void> check_points(OrganViews const& views)
{
    if (views.left.size() < 2 || views.right.size() < 2)
        return fail(Fault::User,
                    "the organ has no boundary: give left or right or both, each of two points or "
                    "more");
    if (views.midrib.size() == 1 || views.section.size() == 1)
        return fail(Fault::User,
                    "the organ's midrib or section is a single point: give two or more, or none "
                    "where it is straight");
    for (auto const* const line : { &views.left, &views.right, &views.midrib, &views.section })
        for (auto const& point : *line)
            if (!point.allFinite() || !(point.cwiseAbs().maxCoeff() < 1e6))
                return fail(Fault::User,
                            "the organ has a number that is too large: give "
                            "millimetres");
    return {};
}

} // namespace

std::vector<Vec2> mirrored(std::vector<Vec2> const& boundary)
{
    std::vector<Vec2> result;
    if (boundary.empty())
        return result;
    Vec2 const base = boundary.front();
    Vec2 const along = (boundary.back() - base).normalized();
    for (auto const& point : boundary) {
        Vec2 const from_base = point - base;
        result.emplace_back(base + 2 * from_base.dot(along) * along - from_base);
    }
    return result;
}

bool has_breadth(OrganViews const& drawn)
{
    constexpr double kNarrowest = 0.005;
    auto const views = with_both(drawn);
    if (views.left.size() < 2 || views.right.size() < 2)
        return false;
    Points around = views.left;
    around.insert(around.end(), views.right.rbegin(), views.right.rend());
    double twice = 0;
    for (std::size_t i = 0; i < around.size(); ++i) {
        auto const& from = around[i];
        auto const& to = around[(i + 1) % around.size()];
        twice += from.x() * to.y() - from.y() * to.x();
    }
    Vec2 const base = (views.left.front() + views.right.front()) / 2;
    Vec2 const tip = (views.left.back() + views.right.back()) / 2;
    return std::fabs(twice) / 2 > kNarrowest * (tip - base).squaredNorm();
}

Result<std::vector<BezierPatch>> organ_surface(OrganViews const& drawn)
{
    auto const views = with_both(drawn);
    TRY(check_points(views));
    auto const sides = TRY(place_sides(views));
    auto const midrib = TRY(heights_of(views.midrib, kAlong, "midrib"));
    auto const section = spline(TRY(heights_of(views.section, kAcross, "section")));
    Points heights; // Width of the organ and height of its midrib, at equal steps from base to tip.
    for (std::size_t i = 0; i < midrib.size(); ++i)
        heights.emplace_back((sides.right[i] - sides.left[i]).norm(),
                             midrib[i].y() * sides.length_mm);
    auto const left = spline(sides.left);
    auto const right = spline(sides.right);
    auto const height = spline(heights);
    std::vector<BezierPatch> patches;
    for (std::size_t row = 0; row < left.size(); ++row)
        for (std::size_t column = 0; column < section.size(); ++column) {
            BezierPatch patch;
            for (std::size_t i = 0; i < 16; ++i) {
                auto const& across = section[column][i % 4];
                Vec2 const flat
                    = left[row][i / 4] + across.x() * (right[row][i / 4] - left[row][i / 4]);
                auto const& up = height[row][i / 4];
                patch.control[i] = { flat.x(), flat.y(), up.x() * across.y() + up.y() };
            }
            auto const number = static_cast<std::uint16_t>(patches.size());
            auto const neighbor = [](bool is_there, int index) {
                return is_there ? static_cast<std::uint16_t>(index) : BezierPatch::kNoPatch;
            };
            patch.neighbors = { neighbor(row > 0, number - kAcross),
                                neighbor(row + 1 < left.size(), number + kAcross),
                                neighbor(column > 0, number - 1),
                                neighbor(column + 1 < section.size(), number + 1) };
            patches.push_back(patch);
        }
    return patches;
}

} // namespace tractus::lines
