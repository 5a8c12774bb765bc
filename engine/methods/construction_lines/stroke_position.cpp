#include "engine/methods/construction_lines/stroke_position.h"

#include "engine/methods/construction_lines/hand_line.h"

#include <algorithm>
#include <cmath>

namespace tractus::lines {

double ramp(double value, double from, double to)
{
    return std::clamp((value - from) / (to - from), 0.0, 1.0);
}

namespace {

// Length by which the axis is prolonged at each end, in stem lengths.
constexpr double kProlonged = 1;

std::vector<Vec2> prolonged(std::span<Vec3 const> stem, double length_mm)
{
    std::vector<Vec3> const backwards(stem.rbegin(), stem.rend());
    std::vector<Vec2> line { stem.front().head<2>()
                             - kProlonged * length_mm * start_direction(stem) };
    for (auto const& point : stem)
        line.emplace_back(point.head<2>());
    line.emplace_back(stem.back().head<2>() - kProlonged * length_mm * start_direction(backwards));
    return line;
}

double seen_length_mm(std::span<Vec3 const> stem)
{
    double sum = 0;
    for (std::size_t i = 1; i < stem.size(); ++i)
        sum += (stem[i] - stem[i - 1]).head<2>().norm();
    return sum;
}

// Distance from the axis, in stem lengths, within which points count as on it, so that tremor
// causes no crossings. On short stems it corresponds to 0.8 mm on the sheet.
double side_margin(double stem_mm)
{
    return std::max(0.012, 0.8 / stem_mm);
}

// Cost of reading a stroke as an inclination line, which crosses the stem and has its ends on
// opposite sides of it.
double inclination_cost(StrokePosition const& lie, double stem_mm)
{
    double const first = lie.first().beside;
    double const last = lie.last().beside;
    double const least = std::min(std::fabs(first), std::fabs(last));
    if (lie.crossings.empty() || first * last >= 0 || least < std::max(0.025, 1.5 / stem_mm))
        return kImpossible;
    double const far = std::max(std::fabs(first), std::fabs(last));
    return 0.05 + 0.8 * static_cast<double>(lie.crossings.size() - 1)
        + 0.7 * ramp(far / least, 3, 10) + 0.8 * ramp(lie.length, 1.4, 2.4)
        + 1.2 * ramp(lie.lean_deg, 25, 8) + 0.8 * ramp(lie.run, 0.75, 0.95);
}

// Cost of reading a stroke as half an inclination line, from the stem outwards.
double half_cost(StrokePosition const& lie, double stem_mm)
{
    bool const starts = std::fabs(lie.first().beside) < std::fabs(lie.last().beside);
    auto const& near = starts ? lie.first() : lie.last();
    auto const& far = starts ? lie.last() : lie.first();
    double const gap = std::fabs(near.beside);
    double const out = std::fabs(far.beside);
    double const over = near.beside * far.beside < 0 ? gap : 0;
    double const most_gap = std::max(0.06, std::min(0.12, 8 / stem_mm));
    if (out < gap + 0.04 || lie.crossings.size() > 1 || near.along < -0.08 || near.along > 1.08)
        return kImpossible;
    // Angle of the half line above the perpendicular to the stem.
    double const rise_deg = degrees(std::atan2(far.along - near.along, out - gap));
    // The term with reach() penalises a stroke that returns towards the stem.
    return 0.1 + 0.35 * ramp(gap, 0.5 * most_gap, most_gap)
        + 1.5 * ramp(gap, most_gap, 2 * most_gap) + 0.8 * ramp(over, 0.03, 0.08)
        + 1.0 * ramp(rise_deg, 60, 78) + 0.9 * ramp(rise_deg, -20, -55)
        + 1.2 * ramp(lie.reach() / out, 1.08, 1.5) + 0.5 * ramp(near.along, 0.97, 1.06);
}

// Cost of reading a stroke as the boundary on one side (1: left, -1: right), or as a piece of it.
double side_cost(StrokePosition const& lie, double side, double stem_mm)
{
    double const over = side > 0 ? lie.reach_right : lie.reach_left;
    double const out = side > 0 ? lie.reach_left : lie.reach_right;
    double const share = side > 0 ? lie.left_share : 1 - lie.left_share;
    if (share < 0.5 || out <= 0.02 || lie.highest < -0.05 || lie.lowest > 1.1)
        return kImpossible;
    double const range = lie.highest - lie.lowest;
    double const near_end = std::min(std::fabs(lie.first().beside), std::fabs(lie.last().beside));
    double const far_end = std::max(std::fabs(lie.first().beside), std::fabs(lie.last().beside));
    bool const from_stem = near_end < 0.06 && far_end > 0.9 * out && range < 0.6;
    return 0.1 + 1.2 * ramp(over, std::max(0.04, 2 / stem_mm), 0.12) + 0.25 * ramp(range, 0.6, 0.2)
        + 2.5 * small_piece(lie) + 0.9 * ramp(lie.run_outside, 0.6, 0.3)
        + 0.7 * ramp(lie.mean_beside, 0.07, 0.03) + (from_stem ? 0.5 : 0);
}

// Cost of reading a stroke as the stem, or a part of the stem, drawn again.
double stem_cost(StrokePosition const& lie)
{
    double const range = lie.highest - lie.lowest;
    double const near_end = std::min(std::fabs(lie.first().beside), std::fabs(lie.last().beside));
    double const far_end = std::max(std::fabs(lie.first().beside), std::fabs(lie.last().beside));
    // Bulge of the stroke: a line that leaves the stem is farthest from it at its end, a boundary
    // in its middle.
    double const bulge = lie.reach() - far_end;
    return 0.15 + 1.2 * ramp(lie.mean_beside, 0.05, 0.12) + 1.2 * ramp(far_end, 0.15, 0.3)
        + 0.6 * ramp(near_end, 0.03, 0.07) + 1.2 * ramp(bulge, 0.03, 0.08)
        + 1.0 * ramp(lie.run, 0.95, 0.8) + 0.8 * ramp(range, 0.2, 0.08)
        + 0.6 * ramp(lie.lean_deg, 10, 20);
}

// Cost of reading a stroke as an outline: both boundaries in one stroke, around the stem's top.
double outline_cost(StrokePosition const& lie)
{
    bool const around_top = std::any_of(lie.crossings.begin(), lie.crossings.end(),
                                        [](double at) { return at > 0.85; });
    double const least = std::min(lie.reach_left, lie.reach_right);
    if (!around_top || least < 0.05)
        return kImpossible;
    int elsewhere = 0;
    for (auto const at : lie.crossings)
        elsewhere += at > 0.85 ? 0 : 1;
    double const range = lie.highest - lie.lowest;
    return 0.1 + 0.6 * std::max(0, elsewhere - 1) + 0.8 * ramp(range, 0.3, 0.15)
        + 0.6 * ramp(lie.length, 1.2 * range + lie.reach_left + lie.reach_right, range)
        + 0.7 * ramp(lie.reach() / least, 4, 10)
        + 1.5 * ramp(std::max(std::fabs(lie.first().along), std::fabs(lie.last().along)), 0.9, 1.05)
        + 0.8 * ramp(std::fabs(lie.first().along - lie.last().along), 0.35, 0.7);
}

} // namespace

double small_piece(StrokePosition const& lie)
{
    return ramp(lie.highest - lie.lowest, 0.15, 0.05);
}

// Share of the stroke's length that runs along the axis, counted only where the stroke is farther
// from the axis than half its maximum distance.
static double run_outside(StrokePosition const& lie)
{
    double run = 0;
    double way = 0;
    for (std::size_t i = 1; i < lie.places.size(); ++i) {
        auto const& from = lie.places[i - 1];
        auto const& to = lie.places[i];
        if (std::fabs(from.beside + to.beside) < lie.reach())
            continue;
        run += std::fabs(to.along - from.along);
        way += std::hypot(to.along - from.along, to.beside - from.beside);
    }
    return run / std::max(way, 1e-9);
}

StemAxis::StemAxis(std::span<Vec3 const> stem)
    : length_mm_(seen_length_mm(stem))
    , line_(prolonged(stem, length_mm_))
{
}

StemAxis::Place StemAxis::place(Vec2 const& point) const
{
    double const at_mm = line_.nearest_mm(point);
    Vec2 const way = point - line_.point(at_mm);
    double const beside_mm
        = std::copysign(way.norm(), cross(direction(line_.heading_deg(at_mm)), way));
    return { at_mm / length_mm_ - kProlonged, beside_mm / length_mm_ };
}

Vec2 StemAxis::tangent(double along) const
{
    return direction(line_.heading_deg((along + kProlonged) * length_mm_));
}

Vec2 StemAxis::point(double along) const
{
    return line_.point((along + kProlonged) * length_mm_);
}

StrokePosition position_along_axis(DrawnLine const& stroke, StemAxis const& axis)
{
    StrokePosition lie;
    for (auto const& point : stroke.points())
        lie.places.push_back(axis.place(point));
    lie.length = stroke.length_mm() / axis.length_mm();
    lie.lowest = lie.highest = lie.first().along;
    double const margin = side_margin(axis.length_mm());
    double side = 0;
    double run = 0;
    for (std::size_t i = 0; i < lie.places.size(); ++i) {
        auto const& [along, beside] = lie.places[i];
        lie.lowest = std::min(lie.lowest, along);
        lie.highest = std::max(lie.highest, along);
        lie.mean_beside += std::fabs(beside);
        lie.reach_left = std::max(lie.reach_left, beside);
        lie.reach_right = std::max(lie.reach_right, -beside);
        lie.left_share += beside > 0 ? 1 : 0;
        if (i > 0)
            run += std::fabs(along - lie.places[i - 1].along);
        if (std::fabs(beside) < margin)
            continue;
        if (side * beside < 0)
            lie.crossings.push_back(along);
        side = beside;
    }
    auto const count = static_cast<double>(lie.places.size());
    lie.mean_beside /= count;
    lie.left_share /= count;
    lie.run = std::min(1.0, run / std::max(lie.length, 1e-9));
    lie.run_outside = run_outside(lie);
    lie.climb = lie.last().along - lie.first().along;
    Vec2 const chord = stroke.points().back() - stroke.points().front();
    Vec2 const tangent = axis.tangent((lie.lowest + lie.highest) / 2);
    lie.lean_deg
        = degrees(std::atan2(std::fabs(cross(tangent, chord)), std::fabs(tangent.dot(chord))));
    return lie;
}

PartCosts part_costs(StrokePosition const& lie, double stem_mm)
{
    PartCosts costs;
    costs.fill(kImpossible);
    auto const put = [&](Part part, double cost) { costs[static_cast<std::size_t>(part)] = cost; };
    put(Part::Stem, stem_cost(lie));
    put(Part::Left, side_cost(lie, 1, stem_mm));
    put(Part::Right, side_cost(lie, -1, stem_mm));
    put(Part::Inclination, inclination_cost(lie, stem_mm));
    put(Part::Half, half_cost(lie, stem_mm));
    put(Part::Outline, outline_cost(lie));
    put(Part::Nothing, kNothingCost);
    return costs;
}

} // namespace tractus::lines
