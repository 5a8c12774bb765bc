#include "engine/variation/stroke_laying.h"

#include "engine/stroke/frame_rotation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tractus::variation {

namespace {

// Sine of 15 degrees: directions this close to the vertical have no heading of their own.
double const kUpright = std::sin(radians(15));

constexpr double kMinStartShare = 0.05;
constexpr double kMaxStartShare = 1.0 / 3;

// A chord that is shorter than this share of the curve between its ends gives no reliable
// direction.
constexpr double kMinChordShare = 0.01;

double horizontal_share(Vec3 const& direction)
{
    return direction.head<2>().norm();
}

Vec2 unit_or(Vec2 const& vector, Vec2 const& otherwise)
{
    double const length = vector.norm();
    return length > 1e-9 ? Vec2(vector / length) : otherwise;
}

Quat turn_about_vertical(Vec2 const& to)
{
    return Quat(Eigen::AngleAxisd(std::atan2(to.y(), to.x()), Vec3::UnitZ()));
}

// Returns the pitch of a direction in the vertical plane of its heading, -pi to pi.
double pitch_rad(Aim const& aim)
{
    return std::atan2(aim.direction.z(), aim.direction.head<2>().dot(aim.heading));
}

Vec3 unit_or(Vec3 const& vector, Vec3 const& otherwise)
{
    double const length = vector.norm();
    return length > 0 ? Vec3(vector / length) : otherwise;
}

// Returns the unit vector along the chord of the curve's first `share`, or of a longer part if the
// stroke turns back on itself at its start.
Vec3 start_of(ArcLength const& curve, double share)
{
    for (; share < 1; share *= 2) {
        Vec3 const chord = curve.at(share) - curve.at(0);
        if (chord.norm() > kMinChordShare * share * curve.length_mm())
            return chord.normalized();
    }
    return unit_or(curve.at(1) - curve.at(0),
                   unit_or(curve.at(0.5) - curve.at(0), Vec3(Vec3::UnitZ())));
}

std::vector<Vec3> even_directions(ArcLength const& curve, int count)
{
    std::vector<Vec3> directions;
    Vec3 from = curve.at(0);
    for (int i = 1; i <= count; ++i) {
        Vec3 const to = curve.at(static_cast<double>(i) / count);
        if (double const length = (to - from).norm(); length > 0)
            directions.push_back((to - from) / length);
        else if (!directions.empty())
            directions.push_back(directions.back());
        from = to;
    }
    return directions;
}

// Returns the angle of the rotation from `a` to `b` about the unit vector `about`, -pi to pi.
double angle_about(Vec3 const& about, Vec3 const& a, Vec3 const& b)
{
    double const cosine = a.dot(b) - a.dot(about) * b.dot(about);
    return std::atan2(about.dot(a.cross(b)), cosine);
}

} // namespace

Quat lay_by_heading(Aim const& stroke, Aim const& branch)
{
    double const branch_pitch_rad
        = std::atan2(branch.direction.z(), horizontal_share(branch.direction));
    // A positive rotation about +y lowers +x.
    Quat const pitch(Eigen::AngleAxisd(-(branch_pitch_rad - pitch_rad(stroke)), Vec3::UnitY()));
    Quat const laid = turn_about_vertical(branch.heading) * pitch
        * turn_about_vertical(stroke.heading).conjugate();
    Vec3 const direction = (laid * stroke.direction).normalized();
    return (least_rotation(direction, branch.direction) * laid).normalized();
}

bool is_upright(Vec3 const& direction)
{
    return horizontal_share(direction) <= kUpright;
}

Aim aim_of_stroke(Vec3 const& direction, Vec2 const& reach)
{
    Vec2 const towards = is_upright(direction) ? reach : Vec2(direction.head<2>());
    return { direction, unit_or(towards, Vec2::UnitX()) };
}

Vec2 branch_heading(Vec3 const& direction, Vec2 const& otherwise)
{
    double const t = std::clamp(horizontal_share(direction) / kUpright, 0.0, 1.0);
    double const weight = t * t * (3 - 2 * t);
    Vec2 const own = unit_or(Vec2(direction.head<2>()), otherwise);
    return unit_or(Vec2(weight * own + (1 - weight) * otherwise), otherwise);
}

Vec2 farthest_reach(std::span<Vec3 const> points)
{
    Vec2 farthest = Vec2::Zero();
    for (auto const& point : points)
        if (Vec2 const reach = (point - points.front()).head<2>();
            reach.squaredNorm() > farthest.squaredNorm())
            farthest = reach;
    return farthest;
}

std::optional<double> first_turn_share(ArcLength const& curve)
{
    constexpr int kParts = 128;
    constexpr double kMinTurning_rad = 3 * kPi;
    auto const directions = even_directions(curve, kParts);
    Vec3 about = Vec3::Zero();
    for (std::size_t i = 1; i < directions.size(); ++i)
        about += directions[i - 1].cross(directions[i]);
    if (about.norm() < 1)
        return std::nullopt;
    about.normalize();
    std::optional<double> first;
    double turned_rad = 0;
    for (std::size_t i = 1; i < directions.size(); ++i) {
        turned_rad += angle_about(about, directions[i - 1], directions[i]);
        if (!first && turned_rad >= 2 * kPi)
            first = static_cast<double>(i) / kParts;
    }
    // A flat loop ends where it began, so the chord of its first turn gives no direction.
    bool const advances
        = first && (curve.at(*first) - curve.at(0)).norm() > 0.1 * *first * curve.length_mm();
    return advances && turned_rad >= kMinTurning_rad ? first : std::nullopt;
}

double start_share(std::span<double const> lengths_mm, std::optional<double> first_turn)
{
    if (first_turn)
        return *first_turn;
    double const total_mm = std::accumulate(lengths_mm.begin(), lengths_mm.end(), 0.0);
    double const shown = total_mm > 0 ? lengths_mm.front() / total_mm : 0;
    return std::clamp(shown, kMinStartShare, kMaxStartShare);
}

SampledStroke sample_stroke(ArcLength const& curve, std::span<double const> lengths_mm,
                            StrokeFit fit, double share)
{
    double const total_mm = std::accumulate(lengths_mm.begin(), lengths_mm.end(), 0.0);
    SampledStroke shown;
    shown.directions.reserve(lengths_mm.size());
    shown.direction = start_of(curve, share);
    Vec3 before = shown.direction;
    Vec3 from = curve.at(0);
    Vec3 reach = Vec3::Zero();
    double sum_mm = 0;
    for (auto const length_mm : lengths_mm) {
        sum_mm += length_mm;
        Vec3 const to = curve.at(total_mm > 0 ? sum_mm / total_mm : 0);
        before = unit_or(Vec3(to - from), before);
        shown.directions.push_back(before);
        reach += length_mm * before;
        from = to;
    }
    if (fit != StrokeFit::Start)
        shown.direction = unit_or(reach, shown.direction);
    return shown;
}

Vec3 branch_direction(std::span<Quat const> frames, std::span<double const> lengths_mm,
                      StrokeFit fit, double share)
{
    double const total_mm = std::accumulate(lengths_mm.begin(), lengths_mm.end(), 0.0);
    double left_mm = fit == StrokeFit::Start ? share * total_mm : total_mm;
    Vec3 const first = tangent_of(frames.front());
    Vec3 reach = Vec3::Zero();
    for (std::size_t i = 0; i < frames.size() && left_mm > 0; ++i) {
        reach += std::min(left_mm, lengths_mm[i]) * tangent_of(frames[i]);
        left_mm -= lengths_mm[i];
    }
    return unit_or(reach, first);
}

Vec2 reach_heading(std::span<Quat const> frames, std::span<double const> lengths_mm,
                   Quat const& turn)
{
    std::vector<Vec3> points { Vec3::Zero() };
    for (std::size_t i = 0; i < frames.size(); ++i)
        points.push_back(points.back() + lengths_mm[i] * (turn * tangent_of(frames[i])));
    return unit_or(farthest_reach(points), Vec2::UnitX());
}

} // namespace tractus::variation
