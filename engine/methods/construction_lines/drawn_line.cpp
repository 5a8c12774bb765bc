#include "engine/methods/construction_lines/drawn_line.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::lines {

// Tolerances for rounding errors. They ensure that a line crossed at the joint of two segments
// counts as crossed only once there.
static constexpr double kRounding = 1e-9;
static constexpr double kParallel = 1e-12;

Vec2 direction(double heading_deg)
{
    double const angle = radians(heading_deg);
    return { -std::sin(angle), std::cos(angle) };
}

double cross(Vec2 const& a, Vec2 const& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

std::vector<double> piece_headings_deg(std::span<Vec2 const> points)
{
    std::vector<double> headings_deg;
    for (std::size_t i = 1; i < points.size(); ++i) {
        Vec2 const way = points[i] - points[i - 1];
        double heading_deg = degrees(std::atan2(-way.x(), way.y()));
        if (i > 1)
            heading_deg += 360 * std::round((headings_deg.back() - heading_deg) / 360);
        headings_deg.push_back(heading_deg);
    }
    return headings_deg;
}

std::vector<double> values_at_points(std::span<double const> piece_values)
{
    auto const& of = piece_values;
    auto const last = of.size() - 1;
    if (of.size() == 1)
        return { of[0], of[0] };
    std::vector<double> values { 1.5 * of[0] - 0.5 * of[1] };
    for (std::size_t i = 1; i < of.size(); ++i)
        values.push_back((of[i - 1] + of[i]) / 2);
    values.push_back(1.5 * of[last] - 0.5 * of[last - 1]);
    return values;
}

DrawnLine::DrawnLine(std::vector<Vec2> points)
    : points_(std::move(points))
{
    CHECK(points_.size() >= 2);
    at_mm_.push_back(0);
    for (std::size_t i = 1; i < points_.size(); ++i)
        at_mm_.push_back(at_mm_.back() + (points_[i] - points_[i - 1]).norm());
    heading_deg_ = values_at_points(piece_headings_deg(points_));
}

DrawnLine::Place place_in(std::span<double const> rising, double value)
{
    auto const inner = rising.subspan(1, rising.size() - 2);
    auto const piece = static_cast<std::size_t>(std::upper_bound(inner.begin(), inner.end(), value)
                                                - inner.begin());
    return { piece, (value - rising[piece]) / (rising[piece + 1] - rising[piece]) };
}

double value_in(std::span<double const> values, DrawnLine::Place const& place)
{
    double const before = values[place.piece];
    return before + place.share * (values[place.piece + 1] - before);
}

DrawnLine::Place DrawnLine::place(double at_mm) const
{
    return place_in(at_mm_, at_mm);
}

Vec2 DrawnLine::point(double at_mm) const
{
    auto const [piece, share] = place(at_mm);
    return points_[piece] + share * (points_[piece + 1] - points_[piece]);
}

double DrawnLine::heading_deg(double at_mm) const
{
    return value_in(heading_deg_, place(at_mm));
}

double DrawnLine::nearest_mm(Vec2 const& point) const
{
    double least = std::numeric_limits<double>::infinity();
    double at_mm = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        auto const& from = points_[i - 1];
        Vec2 const piece = points_[i] - from;
        double const share = std::clamp((point - from).dot(piece) / piece.squaredNorm(), 0.0, 1.0);
        double const distance = (from + share * piece - point).squaredNorm();
        if (distance < least) {
            least = distance;
            at_mm = at_mm_[i - 1] + share * piece.norm();
        }
    }
    return at_mm;
}

double DrawnLine::distance_mm(Vec2 const& to) const
{
    double const at_mm = nearest_mm(to);
    Vec2 const way = to - point(at_mm);
    double const across_mm = cross(direction(heading_deg(at_mm)), way);
    bool const beyond = at_mm <= 0 || at_mm >= length_mm();
    return beyond ? across_mm : std::copysign(way.norm(), across_mm);
}

std::optional<double> DrawnLine::nearest_hit_mm(Vec2 const& from, Vec2 const& way) const
{
    std::optional<double> nearest_mm;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        Vec2 const piece = points_[i] - points_[i - 1];
        double const turn = cross(way, piece);
        if (std::fabs(turn) < kParallel)
            continue;
        Vec2 const to = points_[i - 1] - from;
        double const reach_mm = cross(to, piece) / turn;
        double const share = cross(to, way) / turn;
        if (reach_mm < -kRounding || share < -kRounding || share > 1 + kRounding)
            continue;
        if (!nearest_mm || reach_mm < *nearest_mm)
            nearest_mm = std::max(0.0, reach_mm);
    }
    return nearest_mm;
}

// True if a share of a segment's length counts as on the segment. A segment includes its first
// point; only the last segment of a line includes its end point.
static bool is_on_piece(double share, bool is_last)
{
    return share >= -kRounding && (is_last ? share <= 1 + kRounding : share < 1 - kRounding);
}

std::vector<Vec2> mirrored(DrawnLine const& line, std::span<Vec2 const> points)
{
    std::vector<Vec2> result;
    for (auto const& point : points) {
        double const at_mm = line.nearest_mm(point);
        Vec2 foot = line.point(at_mm);
        if (at_mm <= 0 || at_mm >= line.length_mm()) {
            Vec2 const way = direction(line.heading_deg(at_mm));
            foot += (point - foot).dot(way) * way;
        }
        result.push_back(2 * foot - point);
    }
    return result;
}

std::vector<Crossing> crossings(DrawnLine const& first, DrawnLine const& second)
{
    std::vector<Crossing> found;
    auto const a = first.points();
    auto const b = second.points();
    for (std::size_t i = 1; i < a.size(); ++i) {
        Vec2 const a_piece = a[i] - a[i - 1];
        for (std::size_t j = 1; j < b.size(); ++j) {
            Vec2 const b_piece = b[j] - b[j - 1];
            double const turn = cross(a_piece, b_piece);
            if (std::fabs(turn) < kParallel)
                continue;
            Vec2 const to = b[j - 1] - a[i - 1];
            double const a_share = cross(to, b_piece) / turn;
            double const b_share = cross(to, a_piece) / turn;
            if (!is_on_piece(a_share, i + 1 == a.size())
                || !is_on_piece(b_share, j + 1 == b.size()))
                continue;
            if (found.size() == kMaxCrossings)
                return found;
            found.push_back({ first.at_mm()[i - 1] + a_share * a_piece.norm(),
                              second.at_mm()[j - 1] + b_share * b_piece.norm() });
        }
    }
    return found;
}

} // namespace tractus::lines
