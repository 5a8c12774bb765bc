#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <span>
#include <vector>

namespace tractus::lines {

// The stem of a sketch: a line on the sheet (drawn_line.h) with a depth w towards the viewer, mm.
// Places on it are shares x of its true length, 0 at its base and 1 at its top; boundaries and
// inclination lines are pictures, and meet it as it is seen from the front.
class DrawnStem {
public:
    // (u, v, w) of at least two points, no two neighbours at one place of the sheet; all finite.
    explicit DrawnStem(std::span<Vec3 const> points);

    DrawnLine const& seen() const { return seen_; }
    double length_mm() const { return at_mm_.back(); } // In space.

    // From a place to how far along the line it is seen, and back.
    double seen_mm(double x) const;
    double place(double seen_mm) const;

    // The tangent's direction as it is seen, and how far it rises towards the viewer.
    double heading_deg(double x) const { return seen_.heading_deg(seen_mm(x)); }
    double pitch_deg(double x) const;

    // (u, v, w).
    Vec3 point(double x) const;

    // The place that is nearest to a point in space.
    double nearest_place(Vec3 const& point) const;

    // How the stem stands at a place: unit vectors in (u, v, w) along it, to its left on the sheet,
    // and away from the viewer, which are a turtle's heading, left and down.
    struct Frame {
        Vec3 heading;
        Vec3 left;
        Vec3 behind;
    };
    Frame frame(double x) const;

    // Its direction, as seen, and its rise with the corners of the polyline rounded, so that a stem
    // that goes so ends where the drawn one does. Unlike the tangent, which turns half way from
    // corner to corner, it stays within 0.0015 of the length of what was drawn.
    struct Course {
        double heading_deg = 0;
        double pitch_deg = 0;
    };
    Course course(double x) const;

    // The sharpest turn at a point of the polyline.
    double sharpest_deg() const { return sharpest_deg_; }

private:
    DrawnLine seen_;
    std::vector<double> depth_mm_;
    std::vector<double> at_mm_;     // In space.
    std::vector<double> pitch_deg_; // Of each point.
    // Integrals of the pieces' values from the base to each point.
    std::vector<double> heading_sum_;
    std::vector<double> pitch_sum_;
    double sharpest_deg_ = 0;
    double half_window_ = 0; // Of a course's mean, a share of the length.
};

} // namespace tractus::lines
