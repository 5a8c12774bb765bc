#pragma once

#include "engine/methods/construction_lines/drawn_line.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace tractus::lines {

// How far a value has gone `from` one number `to` another, which may be the smaller: 0 to 1.
double ramp(double value, double from, double to);

// A stem as the axis of a sketch: places along it are shares of its length, 0 at its foot and 1 at
// its top, and go on straight beyond both.
class StemAxis {
public:
    explicit StemAxis(std::span<Vec3 const> stem); // As of DrawnStem.

    double length_mm() const { return length_mm_; }

    // Where a point is: `along`, and how far beside the axis, left above 0; both in stem lengths.
    struct Place {
        double along = 0;
        double beside = 0;
    };
    Place place(Vec2 const& point) const;

    Vec2 tangent(double along) const; // A unit vector.
    Vec2 point(double along) const;

private:
    double length_mm_ = 0;
    DrawnLine line_; // With both ends prolonged.
};

// How a stroke lies to the axis; lengths in stem lengths.
struct StrokeLie {
    std::vector<StemAxis::Place> places; // Evenly along the stroke.
    double length = 0;
    double lowest = 0; // Along the axis.
    double highest = 0;
    double mean_beside = 0; // Of distances, both sides above 0.
    double reach_left = 0;
    double reach_right = 0;
    double left_share = 0;         // Of its points.
    double run = 0;                // What of its length goes along the axis, 0 to 1.
    double run_outside = 0;        // The same of what is more than half as far from it as it gets.
    double climb = 0;              // The way along the axis from its first to its last point.
    double lean_deg = 0;           // Between its chord and the axis there, 0 to 90.
    std::vector<double> crossings; // Where on the axis it changes sides, not counting a tremor.

    StemAxis::Place const& first() const { return places.front(); }
    StemAxis::Place const& last() const { return places.back(); }
    double reach() const { return std::max(reach_left, reach_right); }
};
StrokeLie lie_to_axis(DrawnLine const& stroke, StemAxis const& axis);

// 0 to 1, where a stroke is so short along the axis that by itself it is no boundary.
double small_piece(StrokeLie const& lie);

// What a stroke can be in the explanation of a whole sketch.
enum class Part { Stem, Left, Right, Inclination, Half, Outline, Piece, Nothing };
constexpr std::size_t kPartCount = 8;

// What it costs to take a stroke for a part of the sketch: 0 for one that is drawn as the part is
// meant, 1 for one that hardly is. Nothing has a fixed price, and a Piece of an inclination line is
// priced by what it continues, so that both are not priced here.
using PartCosts = std::array<double, kPartCount>;
constexpr double kNothingCost = 1.6;
constexpr double kImpossible = 50;
PartCosts part_costs(StrokeLie const& lie, double stem_mm);

} // namespace tractus::lines
