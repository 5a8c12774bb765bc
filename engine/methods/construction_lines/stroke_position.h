#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tractus::lines {

// Linear ramp that is 0 at `from` and 1 at `to`, and clamped to this range. `to` may be smaller
// than `from`.
double ramp(double value, double from, double to);

// A stem as the axis of a sketch. Positions along the axis are shares of the stem's length, 0 at
// its foot and 1 at its top. The axis is extended straight beyond both ends.
class StemAxis {
public:
    // The points must meet the requirements of DrawnStem.
    explicit StemAxis(std::span<Vec3 const> stem);

    double length_mm() const { return length_mm_; }

    // Position of a point in stem lengths: along the axis, and beside it, positive on the left.
    struct Place {
        double along = 0;
        double beside = 0;
    };
    Place place(Vec2 const& point) const;

    Vec2 tangent(double along) const; // Unit tangent of the axis.
    Vec2 point(double along) const;

private:
    double length_mm_ = 0;
    DrawnLine line_; // The stem's line with both ends extended.
};

// Position of a stroke relative to the axis; all lengths are shares of the stem's length.
struct StrokePosition {
    // Positions of points that are evenly spaced along the stroke.
    std::vector<StemAxis::Place> places;
    double length = 0;
    double lowest = 0; // Lowest position of the stroke along the axis; `highest`: the highest.
    double highest = 0;
    double mean_beside = 0; // Mean distance of the stroke from the axis, not negative.
    double reach_left = 0;
    double reach_right = 0;
    double left_share = 0; // Share of the stroke's points to the left of the axis.
    double run = 0;        // Share of the stroke's length that runs along the axis, 0 to 1.
    // Like `run`, but only for those parts of the stroke that are farther from the axis than half
    // its maximum distance.
    double run_outside = 0;
    double climb = 0; // Position along the axis of the stroke's last point minus that of its first.
    double lean_deg = 0; // Angle between the stroke's chord and the axis beside it, 0 to 90.
    // Positions on the axis at which the stroke changes sides, ignoring tremor.
    std::vector<double> crossings;

    StemAxis::Place const& first() const { return places.front(); }
    StemAxis::Place const& last() const { return places.back(); }
    double reach() const { return std::max(reach_left, reach_right); }
};
StrokePosition position_along_axis(DrawnLine const& stroke, StemAxis const& axis);

// Returns a value from 0 to 1: at 1 the stroke is clearly too short along the axis to be a boundary
// by itself.
double small_piece(StrokePosition const& lie);

// Role that a stroke can have in a sketch.
enum class Part { Stem, Left, Right, Inclination, Half, Outline, Piece, Nothing };
constexpr std::size_t kPartCount = 8;

// Cost of interpreting a stroke as each Part: 0 if the stroke is drawn exactly as the part should
// be, about 1 if it hardly resembles the part. The costs of Part::Nothing, which is constant, and
// of Part::Piece, which depends on the line that it continues, are not computed here.
using PartCosts = std::array<double, kPartCount>;
constexpr double kNothingCost = 1.6;
constexpr double kImpossible = 50;
PartCosts part_costs(StrokePosition const& lie, double stem_mm);

} // namespace tractus::lines
