#pragma once

#include "engine/methods/silhouettes/plane.h"

#include <span>
#include <vector>

namespace tractus::silhouette {

// The surface that an outline stands for when the tree is seen from other sides: its right and left
// half as curves in (distance from the trunk, height along it), and between them, at an azimuth
// theta, w of the right and 1 - w of the left, w = (1 + cos theta) / 2. It is smooth all around,
// and is the outline at 0 and 180 degrees. In units of the outline.
class CrownSurface {
public:
    CrownSurface(std::span<Vec2 const> outline, std::span<Vec2 const> trunk);

    // Distance from the trunk, and height along it, at the share s of the way from the outline's
    // foot to its top.
    Vec2 at(double s, double theta_deg) const;

    // Points of a half's curve.
    static constexpr std::size_t kPoints = 65;
    // The curve at an azimuth, closed along the trunk: what is inside of it is in the crown.
    std::vector<Vec2> section(double theta_deg) const;

    // Where a point of the plane is: on which side counts as the distance's sign, right above 0.
    Vec2 to_trunk(Vec2 const& point) const;

private:
    Vec2 foot_;
    Vec2 up_;
    std::vector<Vec2> right_; // From foot to top.
    std::vector<Vec2> left_;
};

} // namespace tractus::silhouette
