#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/drawn_stem.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::lines {

// Geometry around a stem. Azimuths are degrees from 0 to below 360 and increase as a turtle rolls:
// 0 is on the stem's left, 90 behind it, 180 on its right and 270 in front of it.

// Angle between two azimuths: 0 to 180 degrees.
double degrees_between(double azimuth_deg, double other_deg);

// depth_of() returns the greatest depth of a line relative to the stem's base, towards the viewer
// or away, as a share of the stem's length. A line whose depth exceeds kFlat counts as drawn in
// space, any other line as drawn on the sheet.
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

// Returns the distance from the stem, in mm, at which the organ's direction meets a boundary. Organ
// and boundary are projected onto the half-plane that is bounded by the stem and contains the
// organ. No value if they do not meet.
std::optional<double> reach_mm(OrganRay const& organ, DrawnStem const& stem,
                               std::span<Vec3 const> boundary);

// The gap in azimuth between two neighbouring boundaries around a stem, and the sizes of organs
// there.
struct SizesAside {
    double low = 0; // Size of organs at the boundary where the gap begins; `high`: where it ends.
    double high = 0;
    // Difference in azimuth between the gap's two boundaries; above 0.
    double gap_deg = 360;
    // `before` is the size at the boundary that precedes the one of `low` around the stem, `behind`
    // that at the boundary that follows the one of `high`. Both gaps to them are above 0. With only
    // two boundaries around the stem, `before` equals `high` and `behind` equals `low`.
    double before = low;
    double before_gap_deg = 360;
    double behind = high;
    double behind_gap_deg = 360;
};

// Returns the size of organs at a share, 0 to 1, of the gap between two boundaries. For gaps up to
// a right angle it follows a quarter of an ellipse whose half-axes are the two boundaries' sizes.
// For half a turn or more it follows two quarter ellipses, which meet in the middle of the gap at
// the mean of the two sizes, so that two opposite boundaries give two half-ellipses. For gaps in
// between the two results are interpolated. If three boundaries lie within less than half a turn,
// the curve blends into the ellipse about the stem through all three, so that many boundaries
// reproduce any cross-section.
double size_between(SizesAside const& sizes, double share);

} // namespace tractus::lines
