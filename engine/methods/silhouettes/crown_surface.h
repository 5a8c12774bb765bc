#pragma once

#include "engine/methods/silhouettes/meridian.h"
#include "engine/methods/silhouettes/plane.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// The surface of a crown around its trunk, in units of the outline.
// A surface derived from an outline alone blends the outline's right and left halves, as curves in
// (distance from the trunk, height along it): at azimuth theta it is w * right + (1 - w) * left
// with w = (1 + cos theta) / 2. It is smooth all around and equals the outline at 0 and 180
// degrees.
// A surface given by meridians was drawn in space (drawn_surface.h).
class CrownSurface {
public:
    CrownSurface(std::span<Vec2 const> outline, std::span<Vec2 const> trunk);

    // Surface through at least two meridians, sorted by azimuth. Between neighbours the distances
    // are interpolated so that two half-axes give an ellipse.
    CrownSurface(std::vector<Meridian> meridians, std::span<Vec2 const> trunk);

    // True if the surface was drawn rather than derived from an outline.
    bool is_drawn() const { return is_drawn_; }

    std::vector<Meridian> const& meridians() const { return meridians_; }

    // (Distance from the trunk, height along it) at the share `s` of the way from the outline's
    // foot to its top, at azimuth `theta_deg`.
    Vec2 at(double s, double theta_deg) const;

    // Number of points of a meridian's curve.
    static constexpr std::size_t kPoints = 65;
    // The curve at an azimuth, closed along the trunk. Points inside it are inside the crown.
    std::vector<Vec2> section(double theta_deg) const;

    // Greatest distance of the surface from the trunk's line at an azimuth and a height; no value
    // if the surface is entirely above or below that height.
    std::optional<double> reach(double theta_deg, double height) const;

    // (Lowest, highest) height of the surface at an azimuth.
    Vec2 heights(double theta_deg) const;

    // True if a point in space is inside the crown. The point is in the frame of TrunkFrame::of().
    bool holds(Vec3 const& point) const;

    // Converts to the trunk's frame. For a point of the drawing plane, the sign of its distance
    // from the trunk gives the side: positive to the right.
    Vec2 to_trunk(Vec2 const& point) const { return frame_.of(point); }
    Vec3 to_trunk(Vec3 const& point) const { return frame_.of(point); }

private:
    TrunkFrame frame_;
    std::vector<Meridian> meridians_; // Meridians sorted by azimuth.
    bool is_drawn_ = false;
};

} // namespace tractus::silhouette
