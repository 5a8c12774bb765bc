#include "engine/methods/construction_lines/drawn_stem.h"

#include <algorithm>
#include <cmath>

namespace tractus::lines {

static std::vector<Vec2> on_sheet(std::span<Vec3 const> points)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.emplace_back(point.x(), point.y());
    return result;
}

DrawnStem::DrawnStem(std::span<Vec3 const> points)
    : seen_(on_sheet(points))
{
    std::vector<double> pitches_deg;
    auto const headings_deg = piece_headings_deg(seen_.points());
    at_mm_ = heading_sum_ = pitch_sum_ = { 0 };
    for (auto const& point : points)
        depth_mm_.push_back(point.z());
    for (std::size_t i = 1; i < points.size(); ++i) {
        double const flat_mm = seen_.at_mm()[i] - seen_.at_mm()[i - 1];
        double const rise_mm = depth_mm_[i] - depth_mm_[i - 1];
        double const length_mm = std::hypot(flat_mm, rise_mm);
        pitches_deg.push_back(degrees(std::atan2(rise_mm, flat_mm)));
        at_mm_.push_back(at_mm_.back() + length_mm);
        heading_sum_.push_back(heading_sum_.back() + headings_deg[i - 1] * length_mm);
        pitch_sum_.push_back(pitch_sum_.back() + pitches_deg.back() * length_mm);
    }
    pitch_deg_ = values_at_points(pitches_deg);
}

double DrawnStem::seen_mm(double x) const
{
    return value_in(seen_.at_mm(), place_in(at_mm_, x * length_mm()));
}

double DrawnStem::place(double seen_mm) const
{
    return value_in(at_mm_, seen_.place(seen_mm)) / length_mm();
}

double DrawnStem::pitch_deg(double x) const
{
    return value_in(pitch_deg_, seen_.place(seen_mm(x)));
}

Vec3 DrawnStem::point(double x) const
{
    double const at_mm = seen_mm(x);
    auto const seen = seen_.point(at_mm);
    return { seen.x(), seen.y(), value_in(depth_mm_, seen_.place(at_mm)) };
}

DrawnStem::Course DrawnStem::mean_course(double low, double high) const
{
    auto const from = place_in(at_mm_, low * length_mm());
    auto const to = place_in(at_mm_, high * length_mm());
    double const length = (high - low) * length_mm();
    return { (value_in(heading_sum_, to) - value_in(heading_sum_, from)) / length,
             (value_in(pitch_sum_, to) - value_in(pitch_sum_, from)) / length };
}

} // namespace tractus::lines
