#include "engine/stroke/nib.h"

#include <algorithm>
#include <cmath>

namespace tractus {

namespace {

constexpr double kBroadest = 4;
constexpr double kPointUntil_rad = 30 * kPi / 180;
constexpr double kSideFrom_rad = 60 * kPi / 180;
// The direction of movement at a tip is measured over this distance to either side of the tip. Over
// a shorter distance, hand tremor dominates.
constexpr double kDirectionOver_mm = 1.5;

// Returns the position of the nearest tip before (step -1) or after (step 1) tip `i` that is at
// least kDirectionOver_mm away from tip `i`. If there is none, returns that of the stroke's first
// or last tip.
Vec3 place_away(std::span<TipSample const> tips, std::size_t i, std::ptrdiff_t step)
{
    auto const last = step < 0 ? std::size_t { 0 } : tips.size() - 1;
    auto at = i;
    while (at != last && (tips[at].position_mm - tips[i].position_mm).norm() < kDirectionOver_mm)
        at = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + step);
    return tips[at].position_mm;
}

// Returns the width of the line that the side of the nib draws, as a share of the side's length:
// the sine of the angle between movement and tilt.
double swept_share(std::span<TipSample const> tips, std::size_t i, Vec2 const& slope)
{
    Vec3 const side(slope.x(), slope.y(), 0);
    Vec3 const way = place_away(tips, i, 1) - place_away(tips, i, -1);
    double const lengths = side.norm() * way.norm();
    return lengths > 0 ? side.cross(way).norm() / lengths : 1;
}

} // namespace

double broadening(Nib nib, std::span<TipSample const> tips, std::size_t i)
{
    auto const& tilt_rad = tips[i].tilt_rad;
    if (nib == Nib::Point || !tilt_rad)
        return 1;
    Vec2 const slope(std::tan(tilt_rad->x()), std::tan(tilt_rad->y()));
    double const part = std::clamp(
        (std::atan(slope.norm()) - kPointUntil_rad) / (kSideFrom_rad - kPointUntil_rad), 0.0, 1.0);
    double const lies = part * part * (3 - 2 * part);
    if (lies == 0)
        return 1;
    return 1 + (kBroadest - 1) * lies * swept_share(tips, i, slope);
}

} // namespace tractus
