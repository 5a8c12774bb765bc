#pragma once

#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/plane.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// A crown's surface around its trunk. Of an outline alone the one that it stands for when the tree
// is seen from other sides: its right and left half as curves in (distance from the trunk, height
// along it), and between them, at an azimuth theta, w of the right and 1 - w of the left,
// w = (1 + cos theta) / 2. It is smooth all around, and is the outline at 0 and 180 degrees. Of
// meridians the one that was drawn (drawn_surface.h). In units of the outline.
class CrownSurface {
public:
    CrownSurface(std::span<Vec2 const> outline, std::span<Vec2 const> trunk);

    // Through meridians, at least two, by their azimuths. Between neighbours distances are such
    // that an ellipse is one of which only its half-axes are given.
    CrownSurface(std::vector<Meridian> meridians, std::span<Vec2 const> trunk);

    // Whether it was drawn, and does not only stand for an outline.
    bool is_drawn() const { return is_drawn_; }

    std::vector<Meridian> const& meridians() const { return meridians_; }

    // Distance from the trunk, and height along it, at the share s of the way from the outline's
    // foot to its top.
    Vec2 at(double s, double theta_deg) const;

    // Points of a half's curve.
    static constexpr std::size_t kPoints = 65;
    // The curve at an azimuth, closed along the trunk: what is inside of it is in the crown.
    std::vector<Vec2> section(double theta_deg) const;

    // How far from the trunk's line the surface is at a height, where it is farthest. No value: it
    // is all below or above.
    std::optional<double> reach(double theta_deg, double height) const;

    // The heights between which it lies, at an azimuth.
    Vec2 heights(double theta_deg) const;

    // Whether a point in space is inside (TrunkFrame::of()).
    bool holds(Vec3 const& point) const;

    // Where a point of the plane is: on which side counts as the distance's sign, right above 0.
    Vec2 to_trunk(Vec2 const& point) const { return frame_.of(point); }
    Vec3 to_trunk(Vec3 const& point) const { return frame_.of(point); }

private:
    TrunkFrame frame_;
    std::vector<Meridian> meridians_; // By their azimuths.
    bool is_drawn_ = false;
};

} // namespace tractus::silhouette
