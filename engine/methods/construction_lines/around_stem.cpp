#include "engine/methods/construction_lines/around_stem.h"

#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::lines {

namespace {

// Number of samples along a line from which its azimuth is computed.
constexpr std::size_t kSamples = 200;

// Minimum size of organs, as a share of the stem's length. The rules of models use the same value
// (line_rules.cpp).
constexpr double kNothing = 1e-6;

// Sizes are represented by their inverse squares: for an ellipse around the stem these have the
// form a + b cos 2t + c sin 2t as a function of the azimuth t.
double inverse_square(double size)
{
    size = std::max(size, kNothing);
    return 1 / (size * size);
}

double sin_deg(double angle_deg)
{
    return std::sin(radians(angle_deg));
}

// Returns the inverse square of the size on a quarter of an ellipse with these half-axes; `share`
// is from 0 at the first half-axis to 1 at the second.
double quarter_at(double first, double second, double share)
{
    double const sine = sin_deg(90 * share);
    return (1 - sine * sine) * inverse_square(first) + sine * sine * inverse_square(second);
}

// Returns the inverse square of the size at the azimuth `turn_deg` on the ellipse through the
// boundaries at the azimuths -before_gap_deg, 0 and gap_deg, by Lagrange interpolation in sines.
double ellipse_at(SizesAside const& sizes, double turn_deg)
{
    double const gap = sin_deg(sizes.gap_deg);
    double const before_gap = sin_deg(sizes.before_gap_deg);
    double const both = sin_deg(sizes.gap_deg + sizes.before_gap_deg);
    double const from_before = sin_deg(turn_deg + sizes.before_gap_deg);
    double const from_low = sin_deg(turn_deg);
    double const from_high = sin_deg(turn_deg - sizes.gap_deg);
    return from_low * from_high / (before_gap * both) * inverse_square(sizes.before)
        - from_before * from_high / (before_gap * gap) * inverse_square(sizes.low)
        + from_before * from_low / (both * gap) * inverse_square(sizes.high);
}

SizesAside reversed(SizesAside const& sizes)
{
    return { sizes.high,           sizes.low,    sizes.gap_deg,       sizes.behind,
             sizes.behind_gap_deg, sizes.before, sizes.before_gap_deg };
}

// Returns the amount by which `quarter`, a value of quarter_at(), is corrected towards the ellipse
// through the gap's two boundaries and the boundary before them.
double towards_ellipse(SizesAside const& sizes, double share, double quarter)
{
    // The correction is applied fully if the three boundaries span an angle that is smaller than
    // half a turn by at least this much.
    constexpr double kWhole_deg = 60;
    double const room_deg = 180 - sizes.gap_deg - sizes.before_gap_deg;
    if (room_deg <= 0)
        return 0;
    double const much = std::min(1.0, room_deg / kWhole_deg);
    return much * much * (1 - share) * (ellipse_at(sizes, share * sizes.gap_deg) - quarter);
}

} // namespace

double degrees_between(double azimuth_deg, double other_deg)
{
    double const off = std::fabs(std::remainder(azimuth_deg - other_deg, 360));
    return std::min(off, 180.0);
}

double depth_of(std::span<Vec3 const> line, std::span<Vec3 const> stem)
{
    double const length_mm = stem.size() < 2 ? 0 : polyline_length_mm(stem);
    double deepest_mm = 0;
    for (auto const& point : line)
        if (!stem.empty())
            deepest_mm = std::max(deepest_mm, std::fabs(point.z() - stem.front().z()));
    return length_mm > 0 ? deepest_mm / length_mm : 0;
}

std::optional<double> azimuth_of(std::span<Vec3 const> line, DrawnStem const& stem)
{
    // Minimum length of the vector sum of the points' offsets from the stem, as a share of the sum
    // of the offsets' lengths: below it, the azimuth is undefined.
    constexpr double kMin = 0.01;
    // Minimum mean distance of the line from the stem, as a share of the stem's length: below it,
    // the line is the stem itself.
    constexpr double kOnStem = 1e-3;
    // Weight of points beyond the stem's ends; all others have the weight 1.
    constexpr double kBeyond = 1e-6;
    Vec2 sum = Vec2::Zero();
    double away = 0;
    double away_mm = 0; // Sum of the points' distances from the stem.
    for (auto const& point : resample(line, kSamples)) {
        double const x = stem.nearest_place(point);
        auto const frame = stem.frame(x);
        Vec3 const way = point - stem.point(x);
        double const weight = x > 0 && x < 1 ? 1 : kBeyond;
        sum += weight * Vec2(way.dot(frame.left), way.dot(frame.behind));
        away += weight * way.norm();
        away_mm += way.norm();
    }
    double const apart_mm = kOnStem * stem.length_mm() * static_cast<double>(kSamples);
    if (sum.norm() <= kMin * away || away_mm < apart_mm)
        return std::nullopt;
    double const azimuth = degrees(std::atan2(sum.y(), sum.x()));
    return azimuth < 0 ? azimuth + 360 : azimuth;
}

double distance_in_space_mm(std::span<Vec3 const> line, DrawnStem const& stem)
{
    double sum_mm = 0;
    for (auto const& point : resample(line, kSamples))
        sum_mm += (point - stem.point(stem.nearest_place(point))).norm();
    return sum_mm / static_cast<double>(kSamples);
}

std::optional<double> reach_mm(OrganRay const& organ, DrawnStem const& stem,
                               std::span<Vec3 const> boundary)
{
    auto const frame = stem.frame(organ.x);
    Vec3 const foot = stem.point(organ.x);
    Vec3 const out = std::cos(radians(organ.azimuth_deg)) * frame.left
        + std::sin(radians(organ.azimuth_deg)) * frame.behind;
    Vec2 const way(std::sin(radians(organ.angle_deg)), std::cos(radians(organ.angle_deg)));
    auto const in_plane = [&](Vec3 const& point) {
        return Vec2((point - foot).dot(out), (point - foot).dot(frame.heading));
    };
    std::optional<double> nearest_mm;
    auto before = in_plane(boundary.front());
    for (auto const& point : boundary.subspan(1)) {
        auto const from = std::exchange(before, in_plane(point));
        // Signed distances of a segment's two ends from the organ's ray.
        double const off = cross(way, from);
        double const next_off = cross(way, before);
        if (off * next_off > 0 || off == next_off)
            continue;
        double const far_mm = (from + off / (off - next_off) * (before - from)).dot(way);
        if (far_mm >= 0 && (!nearest_mm || far_mm < *nearest_mm))
            nearest_mm = far_mm;
    }
    return nearest_mm;
}

double size_between(SizesAside const& sizes, double share)
{
    double const low = inverse_square(sizes.low);
    double const high = inverse_square(sizes.high);
    double const quarter = quarter_at(sizes.low, sizes.high, share);
    double const ellipse = std::clamp(quarter + towards_ellipse(sizes, share, quarter)
                                          + towards_ellipse(reversed(sizes), 1 - share, quarter),
                                      std::min(low, high) / 2, 2 * std::max(low, high));
    bool const is_low = share <= 0.5;
    double const half = quarter_at(is_low ? sizes.low : sizes.high, (sizes.low + sizes.high) / 2,
                                   2 * (is_low ? share : 1 - share));
    double const one = 1 / std::sqrt(ellipse);
    double const two = 1 / std::sqrt(half);
    return one + std::clamp((sizes.gap_deg - 90) / 90, 0.0, 1.0) * (two - one);
}

} // namespace tractus::lines
