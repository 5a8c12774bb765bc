#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

// A crown's surface on one side of the trunk: the curve in which the half plane at an azimuth meets
// it, as (distance from the trunk's line, height along it), from the foot to the top. Units of the
// drawing.
struct Meridian {
    double theta_deg = 0; // 0 to below 360: to the right of the sheet, 90 behind it.
    std::vector<Vec2> curve;
};

// The line that distances from a trunk are taken from: from its foot to its end.
class TrunkFrame {
public:
    explicit TrunkFrame(std::span<Vec2 const> trunk);
    TrunkFrame(Vec2 const& foot, Vec2 const& up);

    Vec2 const& foot() const { return foot_; }

    // Of a point on the sheet: how far to the right of the line it is, and how high along it.
    Vec2 of(Vec2 const& point) const;
    // Of a point in space, whose z is how far behind the sheet it is: to the right, behind, height.
    Vec3 of(Vec3 const& point) const;
    Vec2 to_sheet(Vec2 const& point) const;

private:
    Vec2 foot_;
    Vec2 up_;
};

// An outline's right and left half as meridians at an azimuth and opposite to it, cut where the
// outline is nearest to the trunk's line at its lowest and its highest. The outline is
// counter-clockwise, in the frame's coordinates.
std::vector<Meridian> halves_of(std::span<Vec2 const> outline, double theta_deg);

} // namespace tractus::silhouette
