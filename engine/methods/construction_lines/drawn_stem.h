#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <span>
#include <vector>

namespace tractus::lines {

// The stem of a sketch: a line on the sheet (drawn_line.h) with a depth w towards the viewer, mm.
// Positions x are shares of its true length in space, 0 at its base and 1 at its top. Boundaries
// and inclination lines are drawn on the sheet and refer to the stem's projection, as seen from the
// front.
class DrawnStem {
public:
    // The points (u, v, w), at least two, must be finite, with no two neighbours coinciding on the
    // sheet.
    explicit DrawnStem(std::span<Vec3 const> points);

    DrawnLine const& seen() const { return seen_; }
    double length_mm() const { return at_mm_.back(); } // Length of the stem in space.

    // Converts a position to the arc length of the projected line, and back.
    double seen_mm(double x) const;
    double place(double seen_mm) const;

    // Heading of the projected tangent; pitch_deg() is its elevation towards the viewer.
    double heading_deg(double x) const { return seen_.heading_deg(seen_mm(x)); }
    double pitch_deg(double x) const;

    // The point (u, v, w) at a position.
    Vec3 point(double x) const;

    // The position nearest to a point in space.
    double nearest_place(Vec3 const& point) const;

    // Orientation of the stem at a position: unit vectors in (u, v, w) along it, to its left on the
    // sheet, and away from the viewer. They correspond to a turtle's heading, left and down.
    struct Frame {
        Vec3 heading;
        Vec3 left;
        Vec3 behind;
    };
    Frame frame(double x) const;

    // Heading and pitch with the corners of the polyline rounded, so that a stem that follows them
    // ends where the drawn one does. Unlike the tangent, which turns half-way from corner to
    // corner, the course stays within 0.0015 of the length from the drawn line.
    struct Course {
        double heading_deg = 0;
        double pitch_deg = 0;
    };
    Course course(double x) const;

    // The largest turn at a point of the polyline, in degrees.
    double sharpest_deg() const { return sharpest_deg_; }

private:
    DrawnLine seen_;
    std::vector<double> depth_mm_;
    std::vector<double> at_mm_;     // Arc length in space at each point.
    std::vector<double> pitch_deg_; // Pitch at each point.
    // Integrals of heading and pitch over arc length, from the base to each point.
    std::vector<double> heading_sum_;
    std::vector<double> pitch_sum_;
    double sharpest_deg_ = 0;
    double half_window_ = 0; // Half the averaging window of a course, as a share of the length.
};

} // namespace tractus::lines
