#pragma once

#include "engine/base/vectors.h"

#include <variant>
#include <vector>

namespace tractus::sim {

// A curve in space as a function of its arc length, piecewise straight in steps of at most half a
// millimetre (or between the points of a polyline). World frame, millimetres.
class Path {
public:
    // Through `points_mm`, of which at least two differ.
    explicit Path(std::vector<Vec3> const& points_mm);

    double length_mm() const { return arc_mm_.back(); }
    std::vector<Vec3> const& points_mm() const { return points_mm_; }

    // Returns the place at `arc_mm` from the start, clamped to the path.
    Vec3 position_mm(double arc_mm) const;

    // Unit vector along the path there.
    Vec3 direction(double arc_mm) const;

private:
    std::size_t piece_at(double arc_mm) const;

    std::vector<Vec3> points_mm_; // Neighbours differ.
    std::vector<double> arc_mm_;  // One per point.
};

// Shapes that a hand may be told to draw. World frame, millimetres and radians; angles of
// directions are counterclockwise from +x seen from above.

struct LineShape {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
};

// Around a vertical axis, from `radius_mm` at the foot to `end_radius_mm`. A fraction of a turn
// without rise is an arc.
struct HelixShape {
    Vec3 foot_mm = Vec3::Zero(); // The axis at the height of the start.
    double radius_mm = 0;
    double end_radius_mm = 0;
    double start_rad = 0;
    double turns = 1; // Negative: clockwise.
    double rise_mm = 0;
};

// Goes from one point to another, swinging to the left of the way and then as far to its right, or
// towards +x and then -x where the way is upright.
struct SCurveShape {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
    double swing_mm = 0;
};

// Sets out in one direction and bends steadily, as branches grow.
struct BranchShape {
    Vec3 from_mm = Vec3::Zero();
    double length_mm = 0;
    double heading_rad = 0;   // Direction at the start.
    double elevation_rad = 0; // Over the horizon, at the start.
    double turn_rad = 0;      // Change of the heading on the way …
    double bend_rad = 0;      // … and the elevation.
};

struct PolylineShape {
    std::vector<Vec3> points_mm;
};

using PathShape = std::variant<LineShape, HelixShape, SCurveShape, BranchShape, PolylineShape>;

// Whether a shape has any length, and only finite numbers, and is not absurdly long (10 m).
bool is_drawable(PathShape const& shape);

// The path along a shape, which must be drawable.
Path make_path(PathShape const& shape);

} // namespace tractus::sim
