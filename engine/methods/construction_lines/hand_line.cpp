#include "engine/methods/construction_lines/hand_line.h"

#include "engine/methods/construction_lines/drawn_line.h"
#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tractus::lines {

namespace {

constexpr double kHandSpacing_mm = 0.5;

std::vector<Vec3> evenly(std::span<Vec3 const> points, double spacing_mm)
{
    constexpr double kMaxPoints = 2'000;
    double const count = std::clamp(polyline_length_mm(points) / spacing_mm, 8.0, kMaxPoints);
    return resample(points, static_cast<std::size_t>(std::lround(count)) + 1);
}

// Quadratic course of a line near one of its ends: across = a + b along + c along^2. The frame's
// origin is at the point of the fitted part nearest to that end, and `along` points towards it.
struct Course {
    Vec2 origin;
    Vec2 along;
    Eigen::Vector3d polynomial;
    double rms_mm = 0;

    double along_mm(Vec3 const& point) const { return (point.head<2>() - origin).dot(along); }
    double off_mm(Vec3 const& point) const
    {
        double const at = along_mm(point);
        return cross(along, point.head<2>() - origin)
            - (polynomial[0] + at * (polynomial[1] + at * polynomial[2]));
    }
};

// Fits a course to the points from index `from`, the nearest to the line's front end, to index
// `to`.
Course fit_course(std::span<Vec3 const> points, std::size_t from, std::size_t to)
{
    Course course { .origin = points[from].head<2>(), .along = {}, .polynomial = {} };
    course.along = (points[from] - points[to]).head<2>();
    course.along /= std::max(course.along.norm(), 1e-9);
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = from; i <= to; ++i) {
        double const at = course.along_mm(points[i]);
        Eigen::Vector3d const row(1, at, at * at);
        normal += row * row.transpose();
        right += row * cross(course.along, points[i].head<2>() - course.origin);
    }
    normal.diagonal() += Eigen::Vector3d::Constant(1e-9);
    course.polynomial = normal.ldlt().solve(right);
    for (std::size_t i = from; i <= to; ++i)
        course.rms_mm += std::pow(course.off_mm(points[i]), 2);
    course.rms_mm = std::sqrt(course.rms_mm / static_cast<double>(to - from + 1));
    return course;
}

// Number of points at the front end of the line that form a hook; 0: there is no hook.
std::size_t hook_at_front(std::span<Vec3 const> points, double spacing_mm)
{
    constexpr double kLongestHook_mm = 4.5;
    constexpr double kLongestShare = 0.2;
    constexpr double kMinOff_mm = 0.3;
    // Largest deviation of a point that still follows the line's course, as a share of its distance
    // from the fitted part.
    constexpr double kMaxOff = 0.12;
    double const length_mm = spacing_mm * static_cast<double>(points.size() - 1);
    auto const steps = [&](double mm) {
        return static_cast<std::size_t>(std::lround(std::max(1.0, mm / spacing_mm)));
    };
    auto const from = steps(std::min(kLongestHook_mm, kLongestShare * length_mm));
    auto const to
        = std::min(from + steps(std::clamp(0.25 * length_mm, 3.0, 20.0)), points.size() - 1);
    if (to < from + 3)
        return 0;
    auto const course = fit_course(points, from, to);
    double const tremor_mm = std::max(kMinOff_mm, 3 * course.rms_mm);
    double farthest_mm = 0;
    auto const leaves = [&](Vec3 const& point) {
        double const at_mm = course.along_mm(point);
        return at_mm < farthest_mm - tremor_mm
            || std::fabs(course.off_mm(point)) > std::max(tremor_mm, kMaxOff * std::fabs(at_mm));
    };
    std::size_t hook = 0;
    for (std::size_t i = from; i-- > 0;) {
        if (!leaves(points[i])) {
            hook = 0; // The line returns to its course: this was tremor, not a hook.
            farthest_mm = std::max(farthest_mm, course.along_mm(points[i]));
        } else if (hook == 0) {
            // The hook includes the points where the turn begins.
            hook = std::min(from, i + steps(kMinOff_mm));
        }
    }
    if (hook == 0)
        return 0;
    // Smallest turn of a hook; a smaller turn belongs to the line.
    constexpr double kMinTurn_deg = 30;
    Vec2 const out = (points[0] - points[hook]).head<2>();
    double const turn_deg
        = degrees(std::fabs(std::atan2(cross(course.along, out), course.along.dot(out))));
    return turn_deg < kMinTurn_deg ? 0 : hook;
}

// Smoothing spline on evenly spaced points: minimises sum |x - y|^2 + lambda |second differences of
// x|^2 for each coordinate, by banded Cholesky decomposition of the pentadiagonal matrix.
std::vector<Vec3> smoothing_spline(std::span<Vec3 const> points, double lambda)
{
    auto const n = points.size();
    std::vector<Vec3> x(points.begin(), points.end());
    if (n < 4 || !(lambda > 0))
        return x;
    // Rows of the matrix I + lambda B'B, from the diagonal to the right; B takes second
    // differences.
    std::vector<Eigen::Vector3d> row(n, Eigen::Vector3d(1, 0, 0));
    for (std::size_t i = 0; i + 2 < n; ++i) {
        row[i] += lambda * Eigen::Vector3d(1, -2, 1);
        row[i + 1] += lambda * Eigen::Vector3d(4, -2, 0);
        row[i + 2] += lambda * Eigen::Vector3d(1, 0, 0);
    }
    // Rows of L^T in the decomposition L D L^T of this matrix. The first component, which is 1 in
    // L^T, contains the element of D instead.
    std::vector<Eigen::Vector3d> unit(n);
    for (std::size_t i = 0; i < n; ++i) {
        Eigen::Vector3d r = row[i];
        if (i >= 1) {
            double const d = unit[i - 1][0];
            r[0] -= d * unit[i - 1][1] * unit[i - 1][1];
            r[1] -= d * unit[i - 1][1] * unit[i - 1][2];
        }
        if (i >= 2)
            r[0] -= unit[i - 2][0] * unit[i - 2][2] * unit[i - 2][2];
        unit[i] = { r[0], r[1] / r[0], r[2] / r[0] };
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (i >= 1)
            x[i] -= unit[i - 1][1] * x[i - 1];
        if (i >= 2)
            x[i] -= unit[i - 2][2] * x[i - 2];
    }
    for (std::size_t i = 0; i < n; ++i)
        x[i] /= unit[i][0];
    for (std::size_t i = n; i-- > 0;) {
        if (i + 1 < n)
            x[i] -= unit[i][1] * x[i + 1];
        if (i + 2 < n)
            x[i] -= unit[i][2] * x[i + 2];
    }
    return x;
}

// Applies a smoothing spline that halves the amplitude of waves of the length `cutoff_mm`.
std::vector<Vec3> smoothed(std::span<Vec3 const> points, double spacing_mm, double cutoff_mm)
{
    return smoothing_spline(points, std::pow(cutoff_mm / (2 * kPi * spacing_mm), 4));
}

struct Tremor {
    double rms_mm = 0; // Root mean square deviation perpendicular to the line.
    double wavelength_mm = 0;
};

// Measures a line's deviation from its smooth course, which has no waves shorter than 25 mm (in a
// short line, half the line's length).
Tremor measure_tremor(std::span<Vec3 const> points, double spacing_mm)
{
    constexpr double kWidestSmoothing_mm = 25;
    double const length_mm = spacing_mm * static_cast<double>(points.size() - 1);
    auto const course
        = smoothed(points, spacing_mm, std::min(kWidestSmoothing_mm, 0.5 * length_mm));
    std::vector<double> off_mm;
    double sum = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        Vec2 const way = (course[i + 1] - course[i - 1]).head<2>();
        off_mm.push_back(
            cross(way / std::max(way.norm(), 1e-9), (points[i] - course[i]).head<2>()));
        sum += off_mm.back() * off_mm.back();
    }
    Tremor tremor { .rms_mm = std::sqrt(sum / static_cast<double>(off_mm.size())) };
    double last = 0;
    int changes = 0;
    for (auto const off : off_mm) {
        if (std::fabs(off) < 0.3 * tremor.rms_mm)
            continue;
        changes += last * off < 0 ? 1 : 0;
        last = off;
    }
    tremor.wavelength_mm = 2 * length_mm / std::max(changes, 1);
    return tremor;
}

// Returns the cut-off wavelength at which the remaining tremor turns the line by less than a
// degree.
double cutoff_for(Tremor const& tremor, double length_mm)
{
    constexpr double kClean_mm = 0.02;
    constexpr double kLeft_deg = 0.6;
    constexpr double kMax_mm = 40;
    if (tremor.rms_mm < kClean_mm)
        return 0;
    double const turns_deg = degrees(2 * kPi * tremor.rms_mm / tremor.wavelength_mm);
    double const times = std::pow(std::max(1.0, turns_deg / kLeft_deg), 0.25);
    return std::min({ times * tremor.wavelength_mm, kMax_mm, 0.5 * length_mm });
}

// Indices of a line's corners in ascending order. At a corner the directions over 3 to 10 mm before
// and behind it differ by at least 45 degrees.
std::vector<std::size_t> corners(std::span<Vec3 const> points, double spacing_mm)
{
    constexpr double kCorner_deg = 45;
    constexpr double kShortWaves_mm = 4;
    double const length_mm = spacing_mm * static_cast<double>(points.size() - 1);
    auto const line = smoothed(points, spacing_mm, std::min(kShortWaves_mm, 0.1 * length_mm));
    auto const reach = static_cast<std::size_t>(
        std::max(2.0, std::clamp(0.12 * length_mm, 3.0, 10.0) / spacing_mm));
    auto const gap = std::max<std::size_t>(1, reach / 5);
    auto const turn_deg = [&](std::size_t i) {
        if (i < reach || i + reach >= line.size())
            return 0.0;
        Vec2 const before = (line[i - gap] - line[i - reach]).head<2>();
        Vec2 const behind = (line[i + reach] - line[i + gap]).head<2>();
        return degrees(std::fabs(std::atan2(cross(before, behind), before.dot(behind))));
    };
    std::vector<std::size_t> found;
    std::vector<double> turns_deg;
    for (std::size_t i = 0; i < line.size(); ++i) {
        double const turn = turn_deg(i);
        if (turn < kCorner_deg)
            continue;
        if (!found.empty() && i - found.back() < reach) {
            if (turn > turns_deg.back()) {
                found.back() = i;
                turns_deg.back() = turn;
            }
            continue;
        }
        found.push_back(i);
        turns_deg.push_back(turn);
    }
    return found;
}

} // namespace

bool is_drawn_by_hand(std::span<Vec3 const> points)
{
    constexpr std::size_t kMinPoints = 12;
    constexpr double kMaxSpacing_mm = 3;
    return points.size() >= kMinPoints
        && polyline_length_mm(points) <= kMaxSpacing_mm * static_cast<double>(points.size() - 1);
}

std::vector<Vec3> trim_hooks(std::span<Vec3 const> points)
{
    constexpr double kFine_mm = 0.25;
    auto line = evenly(points, kFine_mm);
    double const spacing_mm = polyline_length_mm(points)
        / static_cast<double>(std::max<std::size_t>(line.size(), 2) - 1);
    for (int end = 0; end < 2; ++end) {
        auto const hook = hook_at_front(line, spacing_mm);
        line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(hook));
        std::reverse(line.begin(), line.end());
    }
    return without_repeats(line);
}

Vec2 start_direction(std::span<Vec3 const> points)
{
    constexpr double kShare = 0.12;
    double const reach_mm = kShare * polyline_length_mm(points);
    double passed_mm = 0;
    std::size_t last = 1;
    for (; last + 1 < points.size(); ++last) {
        passed_mm += (points[last] - points[last - 1]).norm();
        if (passed_mm >= reach_mm)
            break;
    }
    Vec2 const way = (points[last] - points.front()).head<2>();
    return way / std::max(way.norm(), 1e-9);
}

std::vector<Vec3> remove_tremor(std::span<Vec3 const> points)
{
    // Minimum number of points between two corners; between closer ones no tremor is measured.
    constexpr std::size_t kMinPoints = 6;
    auto const line = evenly(points, kHandSpacing_mm);
    double const spacing_mm = polyline_length_mm(points) / static_cast<double>(line.size() - 1);
    auto ends = corners(line, spacing_mm);
    ends.insert(ends.begin(), 0);
    ends.push_back(line.size() - 1);
    std::vector<Vec3> result;
    for (std::size_t i = 1; i < ends.size(); ++i) {
        std::span const part(line.begin() + static_cast<std::ptrdiff_t>(ends[i - 1]),
                             line.begin() + static_cast<std::ptrdiff_t>(ends[i]) + 1);
        std::vector<Vec3> piece(part.begin(), part.end());
        double const length_mm = spacing_mm * static_cast<double>(part.size() - 1);
        if (part.size() >= kMinPoints)
            if (double const cutoff_mm = cutoff_for(measure_tremor(part, spacing_mm), length_mm);
                cutoff_mm > 0)
                piece = smoothed(part, spacing_mm, cutoff_mm);
        if (result.empty()) {
            result = std::move(piece);
            continue;
        }
        result.back() = (result.back() + piece.front()) / 2;
        result.insert(result.end(), piece.begin() + 1, piece.end());
    }
    return without_repeats(result);
}

std::vector<Vec3> clean_hand_line(std::span<Vec3 const> points)
{
    if (!is_drawn_by_hand(points))
        return { points.begin(), points.end() };
    auto const trimmed = trim_hooks(points);
    auto result = trimmed.size() < 3 ? trimmed : remove_tremor(trimmed);
    return result.size() < 2 ? std::vector<Vec3>(points.begin(), points.end()) : result;
}

} // namespace tractus::lines
