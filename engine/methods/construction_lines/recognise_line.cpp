#include "engine/methods/construction_lines/recognise_line.h"

#include "engine/methods/construction_lines/around_stem.h"
#include "engine/methods/construction_lines/lie_to_stem.h"
#include "engine/methods/construction_lines/measure_nodes.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>

namespace tractus::lines {

namespace {

// Tolerances for strokes on a sheet of paper.
constexpr double kOnLine_mm = 6; // Maximum distance between a line and its redrawn version.
// Maximum distance between the ends of a line and those of its redrawn version.
constexpr double kSameEnd_mm = 20;
// Maximum distance along the stem between the beginnings of the two halves of an inclination line.
constexpr double kSameNode_mm = 15;

std::vector<Vec2> flat(std::vector<Vec3> const& points)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.push_back(point.head<2>());
    return result;
}

// Resamples a stroke densely, so that its points represent its whole course.
DrawnLine sampled(std::vector<Vec3> const& stroke)
{
    constexpr double kSpacing_mm = 1;
    double const length_mm = polyline_length_mm(stroke);
    auto const count = std::clamp(length_mm / kSpacing_mm, 50.0, 300.0);
    return DrawnLine(flat(resample(stroke, static_cast<std::size_t>(count))));
}

bool same_ends(DrawnLine const& a, DrawnLine const& b)
{
    auto const near
        = [](Vec2 const& one, Vec2 const& other) { return (one - other).norm() <= kSameEnd_mm; };
    auto const& from = a.points();
    auto const& to = b.points();
    return (near(from.front(), to.front()) && near(from.back(), to.back()))
        || (near(from.front(), to.back()) && near(from.back(), to.front()));
}

bool lies_on(DrawnLine const& stroke, DrawnLine const& line)
{
    auto const on
        = std::count_if(stroke.points().begin(), stroke.points().end(), [&](Vec2 const& point) {
              return (line.point(line.nearest_mm(point)) - point).norm() <= kOnLine_mm;
          });
    return 10 * static_cast<std::size_t>(on) >= 7 * stroke.points().size();
}

// Half an inclination line, from the stem outwards.
struct Half {
    std::vector<Vec2> points;
    double at_mm = 0; // Distance along the stem at which the half begins.
    double side = 1;  // Side of the stem, 1: left; -1: right.
    std::size_t stroke = 0;
};

Half half_from_stem(std::vector<Vec2> points, std::size_t stroke, DrawnLine const& stem)
{
    if (std::fabs(stem.distance_mm(points.front())) > std::fabs(stem.distance_mm(points.back())))
        std::reverse(points.begin(), points.end());
    double const side = stem.distance_mm(points.back()) > 0 ? 1 : -1;
    double const at_mm = stem.nearest_mm(points.front());
    auto const outside = std::find_if(points.begin(), points.end(), [&](Vec2 const& point) {
        return stem.distance_mm(point) * side > 0;
    });
    return { { outside, points.end() }, at_mm, side, stroke };
}

// Returns the points of a half line, extended slightly across the stem.
std::vector<Vec2> line_of(Half const& half, DrawnLine const& stem)
{
    Vec2 const left = direction(stem.heading_deg(half.at_mm) + 90);
    std::vector<Vec2> line { stem.point(half.at_mm)
                             - half.side * (kMinHalf / 2) * stem.length_mm() * left };
    line.insert(line.end(), half.points.begin(), half.points.end());
    return line;
}

std::vector<Vec2> line_of(Half const& half, Half const& other)
{
    std::vector<Vec2> line(half.points.rbegin(), half.points.rend());
    line.insert(line.end(), other.points.begin(), other.points.end());
    return line;
}

// Joins half inclination lines that begin at the same place on opposite sides of the stem.
template<typename Line>
void join(std::vector<Half> halves, DrawnLine const& stem, std::vector<Line>& lines)
{
    while (!halves.empty()) {
        auto const half = halves.front();
        halves.erase(halves.begin());
        auto const other = std::find_if(halves.begin(), halves.end(), [&](Half const& candidate) {
            return candidate.side != half.side
                && std::fabs(candidate.at_mm - half.at_mm) <= kSameNode_mm;
        });
        if (other == halves.end()) {
            lines.push_back({ line_of(half, stem), half.stroke });
        } else {
            lines.push_back({ line_of(half, *other), half.stroke });
            halves.erase(other);
        }
    }
}

// Removes the ends of a boundary that reach across the stem.
std::vector<Vec2> on_side(std::vector<Vec2> line, DrawnLine const& stem, double side)
{
    auto const is_over = [&](Vec2 const& point) { return stem.distance_mm(point) * side < 0; };
    auto const first = std::find_if_not(line.begin(), line.end(), is_over);
    auto const last = std::find_if_not(line.rbegin(), line.rend(), is_over).base();
    return first < last ? std::vector<Vec2>(first, last) : line;
}

} // namespace

std::string name_of(Role role)
{
    switch (role) {
    case Role::Stem:
        return "stem";
    case Role::Left:
        return "left";
    case Role::Right:
        return "right";
    case Role::Inclination:
        return "inclination";
    case Role::HalfInclination:
        return "half inclination";
    case Role::Around:
        return "around";
    case Role::Outline:
        return "closed outline";
    case Role::Unsure:
        break;
    }
    return "unsure";
}

bool LineRecogniser::is_replaced(std::size_t line) const
{
    return std::any_of(lines_.begin(), lines_.end(),
                       [&](RecognisedLine const& other) { return other.replaces == line; });
}

std::optional<std::size_t> LineRecogniser::find_redrawn_line(DrawnLine const& stroke) const
{
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (lines_[i].role == Role::Unsure || is_replaced(i))
            continue;
        auto const line = sampled(strokes_[i]);
        if (same_ends(stroke, line) && lies_on(stroke, line))
            return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> LineRecogniser::newest(Role role) const
{
    for (std::size_t i = lines_.size(); i-- > 0;)
        if (lines_[i].role == role && !is_replaced(i))
            return i;
    return std::nullopt;
}

// Returns the index of the newest boundary near an azimuth that has not been replaced. Boundaries
// on the sheet have the azimuths of the stem's left and right.
std::optional<std::size_t> LineRecogniser::newest_boundary(double azimuth_deg) const
{
    constexpr double kSameSide_deg = 20;
    auto const stem = newest(Role::Stem);
    for (std::size_t i = lines_.size(); stem && i-- > 0;) {
        auto const role = lines_[i].role;
        if (is_replaced(i))
            continue;
        std::optional<double> at_deg;
        if (role == Role::Left || role == Role::Right)
            at_deg = azimuth_of_side(role == Role::Left ? Side::Left : Side::Right);
        else if (role == Role::Around)
            at_deg = azimuth_of(strokes_[i], DrawnStem(strokes_[*stem]));
        if (at_deg && degrees_between(*at_deg, azimuth_deg) < kSameSide_deg)
            return i;
    }
    return std::nullopt;
}

// Recognises a boundary in space, which may lie in front of the stem. No value if the stroke must
// be recognised as a line on the sheet instead, such as an inclination line or the stem drawn
// again.
std::optional<RecognisedLine>
LineRecogniser::recognise_in_space(std::vector<Vec3> const& stroke) const
{
    auto const stem_index = newest(Role::Stem);
    if (!stem_index)
        return std::nullopt;
    DrawnStem const stem(strokes_[*stem_index]);
    auto const lie = lie_of(sampled(stroke), sampled(strokes_[*stem_index]));
    if (!is_boundary_in_space(lie) || distance_in_space_mm(stroke, stem) < kFlat * stem.length_mm())
        return std::nullopt;
    auto const azimuth_deg = azimuth_of(stroke, stem);
    if (!azimuth_deg)
        return std::nullopt;
    return RecognisedLine { .role = Role::Around,
                            .replaces = newest_boundary(*azimuth_deg),
                            .is_along_stem = is_along_stem(lie) };
}

RecognisedLine LineRecogniser::recognise(DrawnLine const& stroke) const
{
    auto const stem_index = newest(Role::Stem);
    if (!stem_index)
        return { .role = Role::Stem };
    if (auto const earlier = find_redrawn_line(stroke))
        return { .role = lines_[*earlier].role, .replaces = earlier, .is_drawn_again = true };
    auto const stem = sampled(strokes_[*stem_index]);
    auto const lie = lie_of(stroke, stem);
    if (is_half(lie, stroke.length_mm() / stem.length_mm()))
        return { .role = Role::HalfInclination };
    if (is_boundary(lie)) {
        auto const side = lie.left_share > 0.5 ? Side::Left : Side::Right;
        return { .role = side == Side::Left ? Role::Left : Role::Right,
                 .replaces = newest_boundary(azimuth_of_side(side)),
                 .is_along_stem = is_along_stem(lie) };
    }
    if (is_inclination(lie))
        return { .role = Role::Inclination };
    return { .role = Role::Unsure, .reason = explain_no_role(lie) };
}

RecognisedLine LineRecogniser::recognised(std::vector<Vec3> const& stroke, Lies lies) const
{
    if (lies == Lies::InSpace)
        if (auto const line = recognise_in_space(stroke))
            return *line;
    return recognise(sampled(stroke));
}

double LineRecogniser::distance_mm(std::vector<Vec3> const& stroke) const
{
    auto const stem_index = newest(Role::Stem);
    if (!stem_index)
        return 0;
    DrawnLine const stem(flat(strokes_[*stem_index]));
    auto const line = sampled(stroke);
    double sum_mm = 0;
    for (auto const& point : line.points())
        sum_mm += (stem.point(stem.nearest_mm(point)) - point).norm();
    return sum_mm / static_cast<double>(line.points().size());
}

RecognisedLine const& LineRecogniser::add(std::vector<Vec3> const& stroke, Lies lies)
{
    auto line = recognised(stroke, lies);
    lines_.push_back(std::move(line));
    strokes_.push_back(stroke);
    return lines_.back();
}

void LineRecogniser::add_known(std::vector<Vec3> const& stroke, Role role)
{
    lines_.push_back({ .role = role });
    strokes_.push_back(stroke);
}

std::vector<LineRecogniser::DrawnInclination>
LineRecogniser::inclinations(DrawnLine const& stem) const
{
    std::vector<DrawnInclination> lines;
    std::vector<Half> halves;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (lines_[i].role == Role::Inclination && !is_replaced(i))
            lines.push_back({ flat(strokes_[i]), i });
        if (lines_[i].role == Role::HalfInclination && !is_replaced(i))
            halves.push_back(half_from_stem(flat(strokes_[i]), i, stem));
    }
    join(std::move(halves), stem, lines);
    return lines;
}

std::vector<std::size_t> LineRecogniser::inclination_strokes() const
{
    std::vector<std::size_t> strokes;
    if (auto const stem = newest(Role::Stem))
        for (auto const& line : inclinations(DrawnLine(flat(strokes_[*stem]))))
            strokes.push_back(line.stroke);
    return strokes;
}

LineSketch LineRecogniser::sketch() const
{
    LineSketch sketch;
    auto const stem_index = newest(Role::Stem);
    if (!stem_index)
        return sketch;
    sketch.stem = strokes_[*stem_index];
    DrawnLine const stem(flat(sketch.stem));
    if (auto const left = newest(Role::Left))
        sketch.left = on_side(flat(strokes_[*left]), stem, 1);
    if (auto const right = newest(Role::Right))
        sketch.right = on_side(flat(strokes_[*right]), stem, -1);
    for (auto& line : inclinations(stem))
        sketch.inclinations.push_back(std::move(line.points));
    for (std::size_t i = 0; i < lines_.size(); ++i)
        if (lines_[i].role == Role::Around && !is_replaced(i))
            sketch.around.push_back(strokes_[i]);
    return sketch;
}

} // namespace tractus::lines
