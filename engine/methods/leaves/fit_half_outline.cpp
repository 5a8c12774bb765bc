#include "engine/methods/leaves/fit_half_outline.h"

#include "engine/methods/leaves/flat_geometry.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr std::size_t kSamples = 500; // Number of samples along a half outline.
constexpr std::size_t kMaxStops = 70;
// Minimum length of a span between two control points, in samples.
constexpr std::size_t kMinSpan = 8;
constexpr double kCorner_deg = 50;

double turn_deg(FlatLine const& line, std::size_t i, std::size_t reach)
{
    Vec2 const before = line[i] - line[i - reach];
    Vec2 const behind = line[i + reach] - line[i];
    return std::abs(degrees(std::atan2(cross(before, behind), before.dot(behind))));
}

// Control points of a curve. Each belongs to a sample of the drawn line.
struct Stops {
    std::vector<std::size_t> samples {};
    std::vector<bool> is_corner {};

    std::size_t count() const { return samples.size(); }

    void insert(std::size_t sample)
    {
        auto const at = std::ranges::lower_bound(samples, sample) - samples.begin();
        samples.insert(samples.begin() + at, sample);
        is_corner.insert(is_corner.begin() + at, false);
    }
};

// Least-squares fit of a HalfOutline's control points, with both ends fixed.
class HalfFit {
public:
    HalfFit(FlatLine const& line, Stops const& stops)
        : line_(line)
        , stops_(stops)
        , square_error_(stops.count() - 1, 0)
    {
        solve();
        measure();
    }

    std::vector<Vec2> const& points() const { return points_; }
    // Root mean square distance of a span's samples from the curve.
    double error(std::size_t span) const { return std::sqrt(square_error_[span]); }
    // Root mean square distance of the samples in the two spans that meet at a control point.
    double error_beside(std::size_t point) const
    {
        return std::sqrt(0.5 * (square_error_[point - 1] + square_error_[point]));
    }

private:
    // Weights with which the control points determine a point of the curve.
    struct Shares {
        std::size_t first = 0;
        // Weights of four successive control points, beginning with the index `first`.
        std::array<double, 4> of {};
    };

    // Weights at the parameter `t`, 0 to 1, of a span of the Catmull-Rom curve that HalfOutline
    // uses.
    Shares shares_at(std::size_t span, double t) const
    {
        double const s = 1 - t;
        double const begin = (1 + 2 * t) * s * s;
        double const leave = t * s * s;
        double const end = t * t * (3 - 2 * t);
        double const arrive = -t * t * s;
        bool const is_straight_before = span == 0 || stops_.is_corner[span];
        bool const is_straight_behind = span + 2 == stops_.count() || stops_.is_corner[span + 1];
        Shares made { .first = span == 0 ? 0 : span - 1 };
        // Weights of four control points, beginning with the one before the span.
        std::array<double, 4> of { 0, begin, end, 0 };
        if (is_straight_before) {
            of[1] -= leave;
            of[2] += leave;
        } else {
            of[0] -= 0.5 * leave;
            of[2] += 0.5 * leave;
        }
        if (is_straight_behind) {
            of[1] -= arrive;
            of[2] += arrive;
        } else {
            of[1] -= 0.5 * arrive;
            of[3] += 0.5 * arrive;
        }
        if (span == 0)
            std::rotate(of.begin(), of.begin() + 1, of.end());
        made.of = of;
        return made;
    }

    // Calls `visit` for each sample of the line with its span, its weights and its index.
    template<typename Visit> void visit_samples(Visit const& visit) const
    {
        for (std::size_t span = 0; span + 1 < stops_.count(); ++span) {
            auto const from = stops_.samples[span];
            auto const to = stops_.samples[span + 1];
            for (auto i = from + 1; i < to; ++i)
                visit(span, shares_at(span, double(i - from) / double(to - from)), i);
        }
    }

    Vec2 direction_at(std::size_t i) const
    {
        auto const from = i >= 2 ? i - 2 : 0;
        auto const to = std::min(i + 2, line_.size() - 1);
        return (line_[to] - line_[from]).normalized();
    }

    // Solves for the control points. Distances of samples across the line have full weight;
    // distances along it have only the weight kAlong.
    void solve()
    {
        constexpr double kAlong = 0.15;
        constexpr double kStay = 1e-3;
        auto const count = static_cast<Eigen::Index>(2 * stops_.count());
        Eigen::MatrixXd moments = kStay * Eigen::MatrixXd::Identity(count, count);
        Eigen::VectorXd sums(count);
        for (std::size_t k = 0; k < stops_.count(); ++k)
            sums.segment<2>(static_cast<Eigen::Index>(2 * k)) = kStay * line_[stops_.samples[k]];
        visit_samples([&](std::size_t, Shares const& shares, std::size_t i) {
            Vec2 const along = direction_at(i);
            Vec2 const across(-along.y(), along.x());
            Eigen::Matrix2d const weight
                = across * across.transpose() + kAlong * along * along.transpose();
            for (std::size_t a = 0; a < 4; ++a) {
                if (shares.of[a] == 0)
                    continue;
                auto const row = static_cast<Eigen::Index>(2 * (shares.first + a));
                sums.segment<2>(row) += shares.of[a] * weight * line_[i];
                for (std::size_t b = 0; b < 4; ++b)
                    if (shares.of[b] != 0)
                        moments.block<2, 2>(row, static_cast<Eigen::Index>(2 * (shares.first + b)))
                            += shares.of[a] * shares.of[b] * weight;
            }
        });
        fix(moments, sums, 0, line_.front());
        fix(moments, sums, count - 2, line_.back());
        Eigen::VectorXd const found = moments.ldlt().solve(sums);
        for (std::size_t k = 0; k < stops_.count(); ++k)
            points_.emplace_back(found.segment<2>(static_cast<Eigen::Index>(2 * k)));
    }

    static void fix(Eigen::MatrixXd& moments, Eigen::VectorXd& sums, Eigen::Index at,
                    Vec2 const& value)
    {
        constexpr double kFirm = 1e6;
        for (Eigen::Index i = 0; i < 2; ++i) {
            moments(at + i, at + i) += kFirm;
            sums[at + i] += kFirm * value[i];
        }
    }

    void measure()
    {
        std::vector<double> counts(square_error_.size(), 0);
        visit_samples([&](std::size_t span, Shares const& shares, std::size_t i) {
            Vec2 at = Vec2::Zero();
            for (std::size_t a = 0; a < 4; ++a)
                if (shares.of[a] != 0)
                    at += shares.of[a] * points_[shares.first + a];
            double const error = cross(direction_at(i), at - line_[i]);
            square_error_[span] += error * error;
            ++counts[span];
        });
        for (std::size_t span = 0; span < counts.size(); ++span)
            square_error_[span] /= std::max(1.0, counts[span]);
    }

    FlatLine const& line_;
    Stops const& stops_;
    std::vector<Vec2> points_;
    std::vector<double> square_error_;
};

std::size_t span_size(Stops const& stops, std::size_t span)
{
    return stops.samples[span + 1] - stops.samples[span];
}

// Splits spans until the curve fits in each of them. On smooth parts of the line, neighbouring
// spans are kept at similar lengths.
void refine(FlatLine const& line, Stops& stops, double tolerance)
{
    while (stops.count() < kMaxStops) {
        HalfFit const fit(line, stops);
        std::vector<std::size_t> added;
        auto const split = [&](std::size_t span) {
            added.push_back((stops.samples[span] + stops.samples[span + 1]) / 2);
        };
        for (std::size_t span = 0; span + 1 < stops.count(); ++span)
            if (fit.error(span) > tolerance && span_size(stops, span) >= 2 * kMinSpan)
                split(span);
        if (added.empty()) {
            for (std::size_t span = 0; span + 2 < stops.count(); ++span) {
                auto const a = span_size(stops, span);
                auto const b = span_size(stops, span + 1);
                if (stops.is_corner[span + 1] || 5 * std::min(a, b) >= 2 * std::max(a, b))
                    continue;
                split(a > b ? span : span + 1);
            }
        }
        std::ranges::sort(added);
        added.erase(std::unique(added.begin(), added.end()), added.end());
        if (added.empty())
            return;
        for (auto const sample : added)
            stops.insert(sample);
    }
}

// Makes corners smooth where a smooth curve fits almost as well.
void drop_false_corners(FlatLine const& line, Stops& stops)
{
    constexpr double kWorse = 1.08;
    for (std::size_t k = 1; k + 1 < stops.count(); ++k) {
        if (!stops.is_corner[k])
            continue;
        double const sharp = HalfFit(line, stops).error_beside(k);
        stops.is_corner[k] = false;
        if (HalfFit(line, stops).error_beside(k) > kWorse * sharp)
            stops.is_corner[k] = true;
    }
}

} // namespace

std::vector<std::size_t> corners_of_half(FlatLine const& half, double window)
{
    double const step = length_of(half) / double(half.size() - 1);
    auto const reach = std::max<std::size_t>(static_cast<std::size_t>(window / step), 2);
    std::vector<double> turns(half.size(), 0);
    for (std::size_t i = reach; i + reach < half.size(); ++i)
        turns[i] = turn_deg(half, i, reach);
    std::vector<std::size_t> corners;
    for (std::size_t i = reach; i + reach < half.size(); ++i) {
        auto const around
            = std::max_element(turns.begin() + static_cast<std::ptrdiff_t>(i - reach),
                               turns.begin() + static_cast<std::ptrdiff_t>(i + reach + 1));
        if (turns[i] > kCorner_deg && turns[i] == *around)
            corners.push_back(i);
    }
    return corners;
}

std::vector<HalfOutline::Point> fit_half_outline(FlatLine const& half, double tolerance,
                                                 double window)
{
    auto line = evenly(half, kSamples);
    line.front() = Vec2(0, 0);
    line.back() = Vec2(0, 1);
    Stops stops { { 0, kSamples - 1 }, { true, true } };
    for (auto const corner : corners_of_half(line, window)) {
        stops.insert(corner);
        stops.is_corner[stops.count() - 2] = true;
    }
    // A half outline with a single span would be a straight line, so it gets a control point in the
    // middle.
    for (std::size_t span = 0; span + 1 < stops.count(); ++span)
        if (stops.count() == 2)
            stops.insert(kSamples / 2);
    refine(line, stops, tolerance);
    drop_false_corners(line, stops);
    refine(line, stops, tolerance);
    HalfFit const fit(line, stops);
    std::vector<HalfOutline::Point> points;
    for (std::size_t k = 0; k < stops.count(); ++k)
        points.push_back({ fit.points()[k], stops.is_corner[k] });
    return points;
}

std::optional<FlatLine> mean_half(FlatLine const& a, FlatLine const& b, double window)
{
    // Largest distance between corresponding corners of the two halves, in units of the blade's
    // length.
    constexpr double kMaxApart = 0.06;
    auto const one = evenly(a, kSamples);
    auto const other = evenly(b, kSamples);
    auto stops = corners_of_half(one, window);
    auto other_stops = corners_of_half(other, window);
    if (stops.size() != other_stops.size())
        return std::nullopt;
    for (std::size_t k = 0; k < stops.size(); ++k)
        if ((one[stops[k]] - other[other_stops[k]]).norm() > kMaxApart)
            return std::nullopt;
    stops.push_back(kSamples - 1);
    other_stops.push_back(kSamples - 1);
    FlatLine mean { 0.5 * (one[0] + other[0]) };
    std::size_t from = 0;
    std::size_t other_from = 0;
    for (std::size_t k = 0; k < stops.size(); ++k) {
        auto const size = stops[k] - from;
        for (std::size_t i = 1; i <= size; ++i) {
            double const share = double(i) / double(size);
            double const across = double(other_from) + share * double(other_stops[k] - other_from);
            mean.push_back(0.5 * (one[from + i] + place_at(other, across)));
        }
        from = stops[k];
        other_from = other_stops[k];
    }
    return mean;
}

} // namespace tractus::leaf
