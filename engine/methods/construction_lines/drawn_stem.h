#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <span>
#include <vector>

namespace tractus::lines {

// The stem of a sketch: a line on the sheet (drawn_line.h) with a depth w towards the viewer, in
// mm. A position x on the stem is a share of its true length in space, 0 at its base and 1 at its
// top. Boundaries and inclination lines are drawn on the sheet and refer to the stem's projection,
// as seen from the front.
class DrawnStem {
public:
    // The points (u, v, w) must be finite and at least two. No two neighbouring points may coincide
    // on the sheet.
    explicit DrawnStem(std::span<Vec3 const> points);

    DrawnLine const& seen() const { return seen_; }
    double length_mm() const { return at_mm_.back(); } // Length of the stem in space.

    // seen_mm() converts a position on the stem to the arc length along its projection; place() is
    // the inverse.
    double seen_mm(double x) const;
    double place(double seen_mm) const;

    // Heading of the stem's tangent as projected on the sheet. pitch_deg() is the tangent's
    // elevation towards the viewer.
    double heading_deg(double x) const { return seen_.heading_deg(seen_mm(x)); }
    double pitch_deg(double x) const;

    // The point (u, v, w) at a position on the stem.
    Vec3 point(double x) const;

    // The position on the stem that is nearest to a point in space.
    double nearest_place(Vec3 const& point) const;

    // Orientation of the stem at a position: unit vectors in (u, v, w) along it, to its left on the
    // sheet, and away from the viewer. They correspond to a turtle's heading, left and down.
    struct Frame {
        Vec3 heading;
        Vec3 left;
        Vec3 behind;
    };
    Frame frame(double x) const;

    // Heading and pitch of the stem with the corners of its polyline rounded. A turtle that follows
    // them ends where the drawn stem does and stays within 0.0015 of the stem's length from it. The
    // tangent, in contrast, turns as early as half-way from one corner to the next.
    struct Course {
        double heading_deg = 0;
        double pitch_deg = 0;
    };
    Course course(double x) const;

    // The largest turn at a point of the stem, in degrees.
    double sharpest_deg() const { return sharpest_deg_; }

private:
    DrawnLine seen_;
    std::vector<double> depth_mm_;
    std::vector<double> at_mm_;     // Arc length in space at each point.
    std::vector<double> pitch_deg_; // Pitch at each point.
    // Integrals of heading and pitch over arc length, from the base to each point of the stem.
    std::vector<double> heading_sum_;
    std::vector<double> pitch_sum_;
    double sharpest_deg_ = 0;
    // Half the length over which course() averages, as a share of the stem's length.
    double half_window_ = 0;
};

} // namespace tractus::lines
