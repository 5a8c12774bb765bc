#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

// The section of a crown's surface with the vertical half plane at one azimuth of the trunk, as
// points (distance from the trunk's line, height along it) from the foot to the top, in the
// drawing's unit.
struct Meridian {
    // Azimuth of the half plane, 0 to below 360: 0 to the right in the sheet, 90 behind it.
    double theta_deg = 0;
    std::vector<Vec2> curve;
};

// Frame of a trunk: its axis is the straight line from the trunk's foot to its end.
class TrunkFrame {
public:
    explicit TrunkFrame(std::span<Vec2 const> trunk);
    TrunkFrame(Vec2 const& foot, Vec2 const& up);

    Vec2 const& foot() const { return foot_; }

    // Converts a point on the sheet to (signed distance to the right of the axis, height along it).
    Vec2 of(Vec2 const& point) const;
    // Converts a point in space (z = distance behind the sheet) to (right, behind, height).
    Vec3 of(Vec3 const& point) const;
    Vec2 to_sheet(Vec2 const& point) const;

private:
    Vec2 foot_;
    Vec2 up_;
};

// Splits an outline into its right and left halves, as meridians at `theta_deg` and opposite to it.
// The cuts are at its lowest and its highest point near the axis. The outline is counter-clockwise,
// in the trunk's frame.
std::vector<Meridian> split_into_meridians(std::span<Vec2 const> outline, double theta_deg);

} // namespace tractus::silhouette
