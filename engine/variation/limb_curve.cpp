#include "engine/variation/limb_curve.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cstddef>

namespace tractus::variation {

namespace {

constexpr int kJoinPieces = 12;

// Distance over which the direction of the stroke's start is measured, as a share of the distance
// between that start and the seat.
constexpr double kStartReach = 0.5;

Vec3 direction_or(Vec3 const& vector, Vec3 const& otherwise)
{
    double const length = vector.norm();
    return length > 0 ? Vec3(vector / length) : otherwise;
}

// Returns the direction of the stroke's start, measured to the first point at least `reach_mm`
// away.
Vec3 start_direction(std::span<LimbPoint const> points, double reach_mm)
{
    Vec3 const from_mm = points.front().place_mm;
    for (auto const& point : points)
        if (Vec3 const way_mm = point.place_mm - from_mm; way_mm.norm() >= reach_mm)
            return direction_or(way_mm, Vec3::UnitZ());
    return direction_or(points.back().place_mm - from_mm, Vec3::UnitZ());
}

} // namespace

LimbCurve::LimbCurve(std::span<LimbPoint const> points, LimbAttachment const& seat)
{
    CHECK(points.size() >= 2);
    join(points, seat);
    double const join_mm = length_to_mm_.empty() ? 0 : length_to_mm_.back();
    double const gap_mm
        = points_.empty() ? 0 : (points[0].place_mm - points_.back().place_mm).norm();
    for (auto const& point : points)
        add(point);
    CHECK(length_mm() > 0);
    drawn_from_ = (join_mm + gap_mm) / length_mm();
}

void LimbCurve::add(LimbPoint const& point)
{
    length_to_mm_.push_back(points_.empty() ? 0
                                            : length_to_mm_.back()
                                    + (point.place_mm - points_.back().place_mm).norm());
    points_.push_back(point);
}

// Adds the curve that joins the stroke to the parent axis. It is a cubic Hermite curve that leaves
// the parent at an acute angle and turns into the stroke's direction. A stroke that begins inside
// the parent's wood is joined by a straight line.
void LimbCurve::join(std::span<LimbPoint const> points, LimbAttachment const& seat)
{
    Vec3 const to_mm = points.front().place_mm;
    double const far_mm = to_mm.norm();
    double const width_mm = points.front().width_mm;
    if (far_mm <= 0)
        return;
    add({ Vec3::Zero(), width_mm });
    if (far_mm <= seat.radius_mm)
        return;
    Vec3 const leaves_mm
        = far_mm * direction_or(to_mm / far_mm + 0.5 * seat.direction, to_mm / far_mm);
    Vec3 const arrives_mm = far_mm * start_direction(points, kStartReach * far_mm);
    for (int i = 1; i < kJoinPieces; ++i) {
        double const t = static_cast<double>(i) / kJoinPieces;
        add({ t * t * (3 - 2 * t) * to_mm + t * (1 - t) * (1 - t) * leaves_mm
                  - t * t * (1 - t) * arrives_mm,
              width_mm });
    }
}

LimbPoint LimbCurve::at(double share) const
{
    double const length_mm = std::clamp(share, 0.0, 1.0) * length_to_mm_.back();
    auto const above
        = std::lower_bound(length_to_mm_.begin() + 1, length_to_mm_.end() - 1, length_mm);
    auto const i = static_cast<std::size_t>(above - length_to_mm_.begin());
    double const step_mm = length_to_mm_[i] - length_to_mm_[i - 1];
    double const part
        = step_mm > 0 ? std::clamp((length_mm - length_to_mm_[i - 1]) / step_mm, 0.0, 1.0) : 1;
    auto const& from = points_[i - 1];
    auto const& to = points_[i];
    return { from.place_mm + part * (to.place_mm - from.place_mm),
             from.width_mm + part * (to.width_mm - from.width_mm) };
}

Vec3 LimbCurve::direction(double share, double reach) const
{
    // The chord is lengthened if the stroke turns back on itself there.
    for (; reach < 1; reach *= 2) {
        Vec3 const chord_mm = at(share + reach).place_mm - at(share - reach).place_mm;
        if (chord_mm.norm() > 0.01 * reach * length_mm())
            return chord_mm.normalized();
    }
    return direction_or(at(1).place_mm - at(0).place_mm, Vec3::UnitZ());
}

} // namespace tractus::variation
