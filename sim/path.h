#pragma once

#include "engine/base/vectors.h"

#include <variant>
#include <vector>

namespace tractus::sim {

// A curve in space, parametrised by arc length and piecewise linear in steps of at most half a
// millimetre (or between the points of a polyline). World frame, millimetres.
class Path {
public:
    // Makes a path through `points_mm`, at least two of which must differ.
    explicit Path(std::vector<Vec3> const& points_mm);

    double length_mm() const { return arc_mm_.back(); }
    std::vector<Vec3> const& points_mm() const { return points_mm_; }

    // Returns the position at `arc_mm` from the start, clamped to the path.
    Vec3 position_mm(double arc_mm) const;

    // Returns the unit tangent at `arc_mm`.
    Vec3 direction(double arc_mm) const;

private:
    std::size_t piece_at(double arc_mm) const;

    std::vector<Vec3> points_mm_; // Neighbouring points differ.
    std::vector<double> arc_mm_;  // Arc length at each point.
};

// Shapes that a hand can draw. World frame, millimetres and radians; headings are counterclockwise
// from +x, seen from above.

struct LineShape {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
};

// A helix around a vertical axis, from `radius_mm` at the start to `end_radius_mm`. A fraction of a
// turn without rise is an arc.
struct HelixShape {
    Vec3 foot_mm = Vec3::Zero(); // Point of the axis at the height of the start.
    double radius_mm = 0;
    double end_radius_mm = 0;
    double start_rad = 0;
    double turns = 1; // Number of turns; negative for clockwise.
    double rise_mm = 0;
};

// A curve from one point to another that swings first to the left of the straight line between
// them, and then equally far to its right. For a vertical line, it swings towards +x and then -x.
struct SCurveShape {
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
    double swing_mm = 0;
};

// A curve that starts in one direction and bends steadily, as branches grow.
struct BranchShape {
    Vec3 from_mm = Vec3::Zero();
    double length_mm = 0;
    double heading_rad = 0;   // Direction at the start.
    double elevation_rad = 0; // Angle above the horizon at the start.
    double turn_rad = 0;      // Change of the heading along the curve.
    double bend_rad = 0;      // Change of the elevation along the curve.
};

struct PolylineShape {
    std::vector<Vec3> points_mm;
};

using PathShape = std::variant<LineShape, HelixShape, SCurveShape, BranchShape, PolylineShape>;

// True if a shape has a positive length, only finite numbers, and is not longer than 10 m.
bool is_drawable(PathShape const& shape);

// Returns the path along a shape, which must be drawable.
Path make_path(PathShape const& shape);

} // namespace tractus::sim
