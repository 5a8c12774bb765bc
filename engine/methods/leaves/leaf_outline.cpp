#include "engine/methods/leaves/leaf_outline.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tractus::leaf {

namespace {

// Number of points of the outline's polyline for each span between two points of a half outline.
constexpr int kPerSpan = 10;

// Returns a Catmull-Rom curve through the points. At a corner the tangent on either side points
// along the chord of the span.
std::vector<Vec2> curve_through(std::vector<HalfOutline::Point> const& points)
{
    auto const slope
        = [&](std::size_t i) -> Vec2 { return 0.5 * (points[i + 1].at - points[i - 1].at); };
    std::vector<Vec2> line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        auto const& a = points[i];
        auto const& b = points[i + 1];
        Vec2 const chord = b.at - a.at;
        bool const is_straight_at_a = a.is_corner || i == 0;
        bool const is_straight_at_b = b.is_corner || i + 2 == points.size();
        // Tangents are limited, so that distant neighbours do not distort a short span.
        auto const held = [&](Vec2 const& tangent) -> Vec2 {
            double const most = 1.5 * chord.norm();
            return tangent.norm() > most ? Vec2(tangent * (most / tangent.norm())) : tangent;
        };
        Vec2 const from = is_straight_at_a ? chord : held(slope(i));
        Vec2 const to = is_straight_at_b ? chord : held(slope(i + 1));
        for (int k = 0; k < kPerSpan; ++k) {
            double const t = double(k) / kPerSpan;
            double const s = 1 - t;
            line.push_back((1 + 2 * t) * s * s * a.at + t * s * s * from
                           + t * t * (3 - 2 * t) * b.at - t * t * s * to);
        }
    }
    line.push_back(points.back().at);
    return line;
}

class ByLength {
public:
    explicit ByLength(std::vector<Vec2> const& line)
        : line_(line)
    {
        lengths_.push_back(0);
        for (std::size_t i = 1; i < line.size(); ++i)
            lengths_.push_back(lengths_.back() + (line[i] - line[i - 1]).norm());
    }

    struct At {
        Vec2 place;
        Vec2 outwards; // Unit normal to the right of the direction from base to tip.
    };
    At at(double share) const
    {
        double const length = share * lengths_.back();
        auto const above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        auto const i = static_cast<std::size_t>(above - lengths_.begin());
        Vec2 const step = line_[i] - line_[i - 1];
        double const gap = lengths_[i] - lengths_[i - 1];
        double const part = gap > 0 ? (length - lengths_[i - 1]) / gap : 0;
        Vec2 const along = gap > 0 ? Vec2(step / gap) : Vec2(Vec2::UnitY());
        return { line_[i - 1] + part * step, { along.y(), -along.x() } };
    }

private:
    std::vector<Vec2> const& line_;
    std::vector<double> lengths_;
};

std::vector<Vec2> with_margin(std::vector<Vec2> const& line, HalfOutline const& half)
{
    if (half.margin == HalfOutline::Margin::Entire || half.count < 1)
        return line;
    ByLength const by_length(line);
    bool const has_teeth = half.margin == HalfOutline::Margin::Teeth;
    double const peak = 0.5 + 0.4 * std::clamp(half.lean, 0.0, 1.0);
    // Positions of points within a tooth or scallop, 0 to 1: its foot, its peak and points in
    // between.
    std::vector<double> phases;
    if (has_teeth)
        phases = { 0, 0.35 * peak, 0.7 * peak, peak, 0.5 + 0.5 * peak };
    else
        phases = { 0, 0.06, 0.2, 0.4, 0.6, 0.8, 0.94 };
    std::vector<Vec2> made;
    auto const add = [&](double share, double tooth) {
        double const fade = std::min({ 1.0, 8 * share, 6 * (1 - share) });
        auto const at = by_length.at(share);
        made.push_back(at.place + tooth * fade * half.depth * at.outwards);
    };
    for (int i = 0; i < half.count; ++i)
        for (double const phase : phases)
            add((i + phase) / half.count,
                has_teeth ? (phase <= peak ? phase / peak : (1 - phase) / (1 - peak))
                          : std::sqrt(std::max(0.0, 1 - (2 * phase - 1) * (2 * phase - 1))));
    add(1, 0);
    return made;
}

HalfOutline varied(HalfOutline half, Outline::Variation const& variation, double width,
                   Random& random)
{
    // Size of the half outline, to which the variation of its points is proportional: narrow leaves
    // vary less.
    double size = 0;
    for (auto const& point : half.points)
        size = std::max(size, 3 * point.at.x());
    size = std::min(size, half.points.back().at.y());
    for (std::size_t i = 1; i < half.points.size(); ++i) {
        auto& at = half.points[i].at;
        at.x() *= width;
        double const spread = variation.point * size;
        if (i + 1 < half.points.size()) { // The ends are fixed, because both halves meet there.
            // Drawn in a statement of its own, because compilers evaluate arguments in different
            // orders.
            double const y = random.normal();
            at += spread * Vec2(random.normal(), y);
        }
        at.x() = std::max(0.0, at.x());
    }
    return half;
}

} // namespace

Outline::Outline(HalfOutline const& right_half, HalfOutline const& left_half,
                 Variation const& variation, Random& random)
{
    if (right_half.points.size() < 2)
        return;
    double const width = std::clamp(1 + variation.width * random.normal(), 0.7, 1.3);
    auto const right = varied(right_half, variation, width, random);
    auto const left = varied(left_half, variation, width, random);
    line_ = with_margin(curve_through(right.points), right);
    auto other = with_margin(curve_through(left.points), left);
    for (std::size_t i = other.size() - 1; i-- > 1;)
        line_.emplace_back(-other[i].x(), other[i].y());
    find_parts();
}

void Outline::find_parts()
{
    constexpr std::size_t kPoints = 12;
    for (std::size_t begin = 0; begin < line_.size(); begin += kPoints) {
        Part part { .begin = begin, .end = std::min(begin + kPoints, line_.size()) };
        part.middle = 0.5 * (line_[begin] + line_[part.end % line_.size()]);
        for (std::size_t i = begin; i <= part.end; ++i)
            part.radius = std::max(part.radius, (line_[i % line_.size()] - part.middle).norm());
        parts_.push_back(part);
    }
}

double Outline::reach(Vec2 const& from, Vec2 const& direction) const
{
    double best = 0;
    double const length = direction.norm();
    for (auto const& part : parts_) {
        if (std::abs(cross(direction, part.middle - from)) > 1.0001 * length * part.radius)
            continue;
        for (std::size_t i = part.begin; i < part.end; ++i) {
            Vec2 const a = line_[i] - from;
            Vec2 const side = line_[i + 1 < line_.size() ? i + 1 : 0] - line_[i];
            double const across = cross(direction, side);
            if (across == 0)
                continue;
            double const far = cross(a, side) / across;
            double const along = cross(a, direction) / across;
            if (along >= 0 && along <= 1 && far > 1e-6 && (best == 0 || far < best))
                best = far;
        }
    }
    return best;
}

void Outline::look_at(Part const& part, Vec2 const& point, Place& best) const
{
    for (std::size_t i = part.begin; i < part.end; ++i) {
        Vec2 const side = line_[i + 1 < line_.size() ? i + 1 : 0] - line_[i];
        double const length2 = side.squaredNorm();
        double const share
            = length2 > 0 ? std::clamp((point - line_[i]).dot(side) / length2, 0.0, 1.0) : 0;
        double const distance = (point - line_[i] - share * side).norm();
        double const along = double(i) + share;
        if (distance < best.distance || (distance == best.distance && along < best.along))
            best = { along, distance };
    }
}

Outline::Place Outline::nearest(Vec2 const& point) const
{
    Place best { 0, std::numeric_limits<double>::infinity() };
    auto const likely = std::ranges::min_element(
        parts_, {}, [&](Part const& part) { return (part.middle - point).squaredNorm(); });
    look_at(*likely, point, best);
    for (auto const& part : parts_) {
        double const far = best.distance + 1.0001 * part.radius;
        if (&part != &*likely && (part.middle - point).squaredNorm() <= far * far)
            look_at(part, point, best);
    }
    return best;
}

double Outline::span(Place const& from, Place const& to) const
{
    return to.along > from.along ? to.along - from.along
                                 : to.along - from.along + static_cast<double>(line_.size());
}

// True if the counter-clockwise way along the outline leads forward from one place to another. A
// way of more than kMax of the outline's points counts as a step back.
bool Outline::is_forward(Place const& from, Place const& to) const
{
    constexpr double kMax = 0.7;
    return span(from, to) <= kMax * static_cast<double>(line_.size());
}

bool Outline::goes_forward(Vec2 const& from, Vec2 const& to) const
{
    return !empty() && is_forward(nearest(from), nearest(to));
}

std::vector<Vec2> Outline::between(Vec2 const& from, Vec2 const& to, double tolerance) const
{
    std::vector<Vec2> made;
    if (empty())
        return made;
    auto const a = nearest(from);
    auto const b = nearest(to);
    if (a.distance > tolerance || b.distance > tolerance || !is_forward(a, b))
        return made;
    for (double i = std::floor(a.along) + 1; i < a.along + span(a, b); ++i)
        made.push_back(line_[static_cast<std::size_t>(i) % line_.size()]);
    // Minimum distance of the points from `from` and `to`, so that no edge has length 0.
    double const least = 1e-6;
    std::erase_if(made, [&](Vec2 const& point) {
        return (point - from).norm() < least || (point - to).norm() < least;
    });
    return made;
}

} // namespace tractus::leaf
