#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/pen_sketch.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::lines {

// Functions that edit a sketch by setting a value of one of its positional functions, such as an
// angle. They change a line locally, as if it had been redrawn by hand.

enum class StemSide { Left, Right };

constexpr double kMinAngle_deg = 2;
constexpr double kGreatestAngle_deg = 175;
constexpr double kMinSize = 0.01; // Minimum size of organs, as a share of the stem's length.
constexpr double kGreatestSize = 2;

// The id of a sketch's line, and the line's new stroke.
struct BentLine {
    scene::ItemId line = 0;
    Stroke stroke {};
};

// Measures the current stem (current_stem()), with defaults for missing lines (Missing::Guessed).
Result<Construction> construction_of(PenSketch const& sketch);

// Rotates one half of an inclination line about its crossing with the stem, so that organs along it
// have the angle `angle_deg` to the stem, as seen on the sheet (Inclination). `number` is the
// line's index in Construction::inclinations. If only the half on the other side is drawn, that
// half is rotated. Fails with a user error if the line is not drawn, or if the sketch would give no
// plant.
Result<BentLine> with_angle(PenSketch const& whole, std::size_t number, StemSide side,
                            double angle_deg);

// Positions along the stem at which organ sizes can be set, from below: at each inclination line,
// and half-way between neighbouring inclination lines.
std::vector<double> size_places(Construction const& construction);

// Moves a boundary at the place with the index `place` among size_places(), along the direction of
// the organs there, so that these have the given size as a share of the stem's length. The boundary
// stays unchanged at the neighbouring places. If the boundary on `side` is not drawn, the other one
// is moved. Fails like with_angle(), or if the organs' direction misses the boundary.
Result<BentLine> with_size(PenSketch const& whole, std::size_t place, StemSide side, double size);

// Positions along a stem at which its heading can be set, as shares of its length from foot to top.
inline constexpr std::array kHeadingPlaces { 0.0, 1.0 / 3, 2.0 / 3, 1.0 };
// Maximum heading of a stem to the left or right of upright.
constexpr double kGreatestHeading_deg = 90;

// Bends a stem so that at one of kHeadingPlaces it has the heading `heading_deg` on the sheet,
// measured from up and positive to the left. The stem's heading at the neighbouring places, its
// foot and its length are unchanged. The sheet bends with the stem: lines cross it where they did
// and reach as far, and stems attached to it keep their shape. Fails with a user error if the line
// is not a stem, or if the sketch would give no plant.
Result<PenSketch> with_heading(PenSketch sketch, scene::ItemId stem, std::size_t place,
                               double heading_deg);

} // namespace tractus::lines
