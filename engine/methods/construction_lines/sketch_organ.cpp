#include "engine/methods/construction_lines/sketch_organ.h"

#include "engine/methods/construction_lines/pen_sketch.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace tractus::lines {

namespace {

using Line = std::vector<Vec2>;

Result<Line> flat_points(SketchLine const& line)
{
    Line points;
    for (auto const& point : TRY(points_on_sheet(line)))
        points.emplace_back(point.head<2>());
    return points;
}

Vec2 middle(Line const& line)
{
    Vec2 sum = Vec2::Zero();
    for (auto const& point : line)
        sum += point;
    return sum / static_cast<double>(line.size());
}

// Signed distance of a line's middle from the straight line through `base` and `tip`, times the
// distance between `base` and `tip`; positive on the left.
double leftwards(Line const& line, Vec2 const& base, Vec2 const& tip)
{
    Vec2 const way = tip - base;
    Vec2 const at = middle(line) - base;
    return way.x() * at.y() - way.y() * at.x();
}

// The left and right side of a leaf seen from above, and their indices among its drawn lines; -1
// for a side that was not drawn.
struct DrawnSides {
    std::array<Line, 2> lines;
    std::array<std::ptrdiff_t, 2> drawn { -1, -1 };
};

Result<DrawnSides> sides_of(SketchOrgan const& organ)
{
    DrawnSides sides;
    std::size_t count = 0;
    for (std::size_t i = 0; i < organ.lines.size() && count < 2; ++i) {
        if (organ.lines[i].view != OrganView::Side)
            continue;
        sides.lines[count] = TRY(flat_points(organ.lines[i].line));
        sides.drawn[count++] = static_cast<std::ptrdiff_t>(i);
    }
    auto& [first, second] = sides.lines;
    if (count == 0 || (first.back() - first.front()).norm() <= 0)
        return fail(Fault::User,
                    "the leaf has no side yet: draw one of its edges from base to tip");
    if (count == 1)
        second = mirrored(first);
    return sides;
}

// Returns the leaf's midrib or section as positions along the straight line between its ends and
// heights above it; empty if it was not drawn.
Result<Line> view_of(SketchOrgan const& organ, OrganView view)
{
    auto const found
        = std::find_if(organ.lines.begin(), organ.lines.end(),
                       [&](SketchOrgan::Line const& line) { return line.view == view; });
    if (found == organ.lines.end())
        return Line();
    auto points = TRY(flat_points(found->line));
    bool const is_leftwards = points.back().x() < points.front().x();
    if (is_leftwards && view == OrganView::Section)
        std::reverse(points.begin(), points.end());
    double const up = is_leftwards && view == OrganView::Midrib ? -1 : 1;
    Vec2 const base = points.front();
    Vec2 const along = (points.back() - base).normalized();
    for (auto& point : points) {
        Vec2 const from_base = point - base;
        point = { from_base.dot(along),
                  up * (along.x() * from_base.y() - along.y() * from_base.x()) };
    }
    return points;
}

// Index of the drawn line that a new line of the leaf replaces; -1 if it replaces none.
Result<std::ptrdiff_t> replaced_by(SketchOrgan const& organ, SketchOrgan::Line const& line)
{
    auto const points = TRY(flat_points(line.line));
    auto const& lines = organ.lines;
    auto const same = std::find_if(lines.begin(), lines.end(), [&](SketchOrgan::Line const& other) {
        return other.view == line.view;
    });
    if (same == lines.end())
        return -1;
    if (line.view != OrganView::Side)
        return same - lines.begin();
    auto const sides = TRY(sides_of(organ));
    auto const away = [&](Line const& side) { return (middle(side) - middle(points)).norm(); };
    return sides.drawn[away(sides.lines[0]) <= away(sides.lines[1]) ? 0 : 1];
}

} // namespace

Vec3 rgb_of(OrganColor color)
{
    switch (color) {
    case OrganColor::White:
        return { 0.93, 0.92, 0.88 };
    case OrganColor::Yellow:
        return { 0.93, 0.74, 0.10 };
    case OrganColor::Pink:
        return { 0.86, 0.42, 0.60 };
    case OrganColor::Violet:
        return { 0.45, 0.25, 0.65 };
    case OrganColor::Red:
        return { 0.75, 0.10, 0.10 };
    case OrganColor::Brown:
        return { 0.42, 0.28, 0.14 };
    case OrganColor::Leaf:
    case OrganColor::Picture:
        break;
    }
    return { 0.26, 0.46, 0.16 };
}

OrganColor nearest_color(Vec3 const& rgb)
{
    using enum OrganColor;
    constexpr std::array kNamed { Leaf, White, Yellow, Pink, Violet, Red, Brown };
    return *std::min_element(kNamed.begin(), kNamed.end(), [&](OrganColor one, OrganColor other) {
        return (rgb_of(one) - rgb).norm() < (rgb_of(other) - rgb).norm();
    });
}

Result<SketchOrgan> with_organ_line(SketchOrgan organ, SketchOrgan::Line line)
{
    auto const replaced = TRY(replaced_by(organ, line));
    if (replaced >= 0)
        organ.lines.erase(organ.lines.begin() + replaced);
    organ.lines.push_back(std::move(line));
    TRY(surface_of(organ));
    return organ;
}

Result<OrganViews> views_of(SketchOrgan const& organ)
{
    auto sides = TRY(sides_of(organ));
    auto& [first, second] = sides.lines;
    if ((second.back() - first.front()).norm() < (second.front() - first.front()).norm())
        std::reverse(second.begin(), second.end());
    Vec2 const base = (first.front() + second.front()) / 2;
    Vec2 const tip = (first.back() + second.back()) / 2;
    bool const is_left = leftwards(first, base, tip) >= leftwards(second, base, tip);
    return OrganViews { .left = is_left ? first : second,
                        .right = is_left ? second : first,
                        .midrib = TRY(view_of(organ, OrganView::Midrib)),
                        .section = TRY(view_of(organ, OrganView::Section)) };
}

Result<OrganSurface> surface_of(SketchOrgan const& organ)
{
    auto const views = TRY(views_of(organ));
    if (!has_breadth(views))
        return fail(Fault::User,
                    "the leaf would have no breadth: draw its edge as a bow from base to tip");
    OrganSurface surface { .patches = TRY(organ_surface(views)) };
    if (organ.color == OrganColor::Picture)
        surface.picture = organ.picture;
    else if (organ.color != OrganColor::Leaf)
        surface.color = rgb_of(organ.color);
    return surface;
}

} // namespace tractus::lines
