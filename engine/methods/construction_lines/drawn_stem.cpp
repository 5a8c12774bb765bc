#include "engine/methods/construction_lines/drawn_stem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus::lines {

static std::vector<Vec2> on_sheet(std::span<Vec3 const> points)
{
    std::vector<Vec2> result;
    for (auto const& point : points)
        result.emplace_back(point.x(), point.y());
    return result;
}

static double sharpest_turn(std::vector<double> const& piece_deg)
{
    double sharpest_deg = 0;
    for (std::size_t i = 1; i < piece_deg.size(); ++i)
        sharpest_deg = std::max(sharpest_deg, std::fabs(piece_deg[i] - piece_deg[i - 1]));
    return sharpest_deg;
}

// Half the length over which course() averages, as a share of the stem's length. It is half the
// longest segment, so that the segments of a smooth curve look smooth, but less at sharp corners: a
// corner of d radians is cut by d / 4 times this value.
static double half_window(double longest_piece, double sharpest_deg)
{
    constexpr double kMin = 0.0025;
    constexpr double kEnough = 0.004;
    constexpr double kMaxCut = 0.0015;
    double const most = 4 * kMaxCut / std::max(radians(sharpest_deg), 1e-3);
    return std::max(kMin, std::min(std::max(longest_piece / 2, kEnough), most));
}

DrawnStem::DrawnStem(std::span<Vec3 const> points)
    : seen_(on_sheet(points))
{
    std::vector<double> pitches_deg;
    double longest_mm = 0;
    auto const headings_deg = piece_headings_deg(seen_.points());
    at_mm_ = heading_sum_ = pitch_sum_ = { 0 };
    for (auto const& point : points)
        depth_mm_.push_back(point.z());
    for (std::size_t i = 1; i < points.size(); ++i) {
        double const flat_mm = seen_.at_mm()[i] - seen_.at_mm()[i - 1];
        double const rise_mm = depth_mm_[i] - depth_mm_[i - 1];
        double const piece_mm = std::hypot(flat_mm, rise_mm);
        longest_mm = std::max(longest_mm, piece_mm);
        pitches_deg.push_back(degrees(std::atan2(rise_mm, flat_mm)));
        at_mm_.push_back(at_mm_.back() + piece_mm);
        heading_sum_.push_back(heading_sum_.back() + headings_deg[i - 1] * piece_mm);
        pitch_sum_.push_back(pitch_sum_.back() + pitches_deg.back() * piece_mm);
    }
    pitch_deg_ = values_at_points(pitches_deg);
    sharpest_deg_ = std::max(sharpest_turn(headings_deg), sharpest_turn(pitches_deg));
    half_window_ = half_window(longest_mm / length_mm(), sharpest_deg_);
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

double DrawnStem::nearest_place(Vec3 const& point) const
{
    double least = std::numeric_limits<double>::infinity();
    double at_mm = 0;
    auto const seen = seen_.points();
    Vec3 from(seen[0].x(), seen[0].y(), depth_mm_[0]);
    for (std::size_t i = 1; i < seen.size(); ++i) {
        Vec3 const to(seen[i].x(), seen[i].y(), depth_mm_[i]);
        Vec3 const piece = to - from;
        double const share = std::clamp((point - from).dot(piece) / piece.squaredNorm(), 0.0, 1.0);
        double const distance = (from + share * piece - point).squaredNorm();
        if (distance < least) {
            least = distance;
            at_mm = at_mm_[i - 1] + share * (at_mm_[i] - at_mm_[i - 1]);
        }
        from = to;
    }
    return at_mm / length_mm();
}

DrawnStem::Frame DrawnStem::frame(double x) const
{
    double const heading = radians(heading_deg(x));
    double const pitch = radians(pitch_deg(x));
    Vec3 const along(-std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch),
                     std::sin(pitch));
    Vec3 const left(-std::cos(heading), -std::sin(heading), 0);
    return { along, left, left.cross(along) };
}

DrawnStem::Course DrawnStem::course(double x) const
{
    constexpr double kMinAtEnds = 1e-4;
    // The window is symmetric about x. Otherwise the ends would lean inwards.
    double const half = std::max(kMinAtEnds, std::min({ half_window_, x, 1 - x }));
    double const low = std::max(0.0, x - half);
    double const high = std::min(1.0, x + half);
    auto const from = place_in(at_mm_, low * length_mm());
    auto const to = place_in(at_mm_, high * length_mm());
    double const between_mm = (high - low) * length_mm();
    return { (value_in(heading_sum_, to) - value_in(heading_sum_, from)) / between_mm,
             (value_in(pitch_sum_, to) - value_in(pitch_sum_, from)) / between_mm };
}

} // namespace tractus::lines
