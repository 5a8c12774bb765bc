#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/drawn_stem.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// Geometry around a stem. Azimuths are degrees from 0 to below 360, in the turtle's sense of
// rolling: 0 on the stem's left, 90 behind it, 180 on its right and 270 in front of it.

// Angle between two azimuths: 0 to 180 degrees.
double degrees_between(double azimuth_deg, double other_deg);

// Maximum change in depth along a line, towards the viewer or away, relative to the stem's base and
// as a share of the stem's length. A line with more than kFlat is considered drawn in space,
// otherwise on the sheet.
constexpr double kFlat = 0.05;
double depth_of(std::span<Vec3 const> line, std::span<Vec3 const> stem);

// Returns the mean azimuth of a line about the stem, or no value if the line lies on the stem or
// winds around it. `line`: at least two points, all finite.
std::optional<double> azimuth_of(std::span<Vec3 const> line, DrawnStem const& stem);

// Mean distance of a line from the stem, mm.
double distance_in_space_mm(std::span<Vec3 const> line, DrawnStem const& stem);

// An organ's position along and around the stem, and its angle to the stem.
struct OrganRay {
    double x = 0;
    double azimuth_deg = 0;
    double angle_deg = 0; // Angle between organ and stem, 0 to 180.
};

// Returns the distance from the stem, in mm, at which the organ's direction meets a boundary. Both
// are projected onto the half-plane through stem and organ. No value if they do not meet.
std::optional<double> reach_mm(OrganRay const& organ, DrawnStem const& stem,
                               std::span<Vec3 const> boundary);

// The gap around a stem's cross-section between two neighbouring boundaries.
struct SizesAside {
    double low = 0; // Sizes of organs at the gap's two boundaries.
    double high = 0;
    // Difference in azimuth between the two boundaries; above 0.
    double gap_deg = 360;
    // Sizes at the next boundaries around the stem, before `low` and behind `high`, and the gaps to
    // them, above 0. If there are only two boundaries in all, these are `high` and `low` again.
    double before = low;
    double before_gap_deg = 360;
    double behind = high;
    double behind_gap_deg = 360;
};

// Returns the size of organs at a share, 0 to 1, of the gap between two boundaries. For gaps up to
// a right angle it follows a quarter of an ellipse whose half-axes are the two sizes. For half a
// turn or more it follows two quarters, which meet in the middle of the gap at the mean of both
// sizes, so two opposite boundaries give two half-ellipses. Gaps in between are interpolated. If
// three boundaries are within less than half a turn, the curve blends into the ellipse about the
// stem through all three, so that many boundaries reproduce any cross-section.
double size_between(SizesAside const& sizes, double share);

} // namespace tractus::lines
