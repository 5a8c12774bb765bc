#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/drawn_stem.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// Azimuths around a stem are degrees from 0 to below 360, as the turtle rolls: 0 on its left, 90
// behind it, 180 on its right and 270 in front of it.

// How far apart two azimuths are: 0 to 180 degrees.
double degrees_between(double azimuth_deg, double other_deg);

// How far a line in space gets from where the stem begins, towards the viewer or away, by the
// stem's length. A line that does so by more than kFlat is meant in space, else on the sheet.
constexpr double kFlat = 0.05;
double depth_of(std::span<Vec3 const> line, std::span<Vec3 const> stem);

// Where a line goes along a stem: the azimuth of the ways from the stem to it, in the mean. No
// value: it lies on the stem, or goes around it. At least two points, all finite.
std::optional<double> azimuth_of(std::span<Vec3 const> line, DrawnStem const& stem);

// How far a line is from the stem on average, mm.
double distance_in_space_mm(std::span<Vec3 const> line, DrawnStem const& stem);

// An organ of a stem: where it stands, around and along it, and its angle to the stem.
struct OrganRay {
    double x = 0;
    double azimuth_deg = 0;
    double angle_deg = 0; // 0 to 180.
};

// How far the organ goes to where it meets a boundary, mm, which is taken for the line that it
// makes in the half-plane of stem and organ when it is looked at from across that. No value: it
// does not meet it.
std::optional<double> reach_mm(OrganRay const& organ, DrawnStem const& stem,
                               std::span<Vec3 const> boundary);

// Around a stem's cross-section, from one boundary to the next one.
struct SizesAside {
    double low = 0; // Sizes at both.
    double high = 0;
    double gap_deg = 360; // From one to the other; above 0, as the others.
    // The boundary before the first one, and the one behind the second; they may be those
    // themselves.
    double before = low;
    double before_gap_deg = 360;
    double behind = high;
    double behind_gap_deg = 360;
};

// The size at a share, 0 to 1, of the gap: up to a right angle it is a quarter of an ellipse, whose
// half-axes the two sizes are, from half a turn on two quarters that have their mean as a common
// half-axis in the middle of the gap, so that around two opposite boundaries there are two
// half-ellipses; and in between it goes over from the one to the other. Where three boundaries
// stand within less than half a turn it goes over to the ellipse about the stem through all three,
// so that many boundaries give back a cross-section wherever they are.
double size_between(SizesAside const& sizes, double share);

} // namespace tractus::lines
