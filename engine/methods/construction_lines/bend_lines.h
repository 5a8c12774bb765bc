#pragma once

#include "engine/base/result.h"
#include "engine/methods/construction_lines/pen_sketch.h"

#include <array>
#include <cstddef>
#include <vector>

namespace tractus::lines {

// Setting a sketch's functions by their values: its lines follow, as if a hand had drawn them again
// there and nowhere else.

enum class StemSide { Left, Right };

constexpr double kLeastAngle_deg = 2;
constexpr double kGreatestAngle_deg = 175;
constexpr double kLeastSize = 0.01; // Shares of the stem's length.
constexpr double kGreatestSize = 2;

// A line of a sketch with the tips that it is to have.
struct BentLine {
    scene::ItemId line = 0;
    Stroke stroke {};
};

// The stem in hand (stem_in_hand()) as measure_sketch() takes it with Missing::Guessed.
Result<Construction> construction_of(PenSketch const& sketch);

// Turns one half of an inclination line about where it crosses the stem, so that what grows along
// it leaves the stem at this angle, as it is seen (Inclination). `number` is the line's among the
// construction's. Where only the other half is drawn, that one is turned. Fails, as the user's
// fault, where nobody has drawn that line, and where the sketch would give no plant.
Result<BentLine> with_angle(PenSketch const& whole, std::size_t number, StemSide side,
                            double angle_deg);

// Places along the stem at which sizes can be set: at the inclination lines, and in the middle
// between them. From below.
std::vector<double> size_places(Construction const& construction);

// Moves the boundary to or from the stem, along the ray of what grows at one of those places, so
// that its size there is this share of the stem's length; what the boundary is at the next places
// stays. Where only the other boundary is drawn, that one is moved. Fails like with_angle(), and
// where the ray misses the boundary.
Result<BentLine> with_size(PenSketch const& whole, std::size_t place, StemSide side, double size);

// Places along a stem at which its direction can be set: shares of it, from its foot to its top.
inline constexpr std::array kHeadingPlaces { 0.0, 1.0 / 3, 2.0 / 3, 1.0 };
constexpr double kGreatestHeading_deg = 90; // To either side.

// Bends a stem so that at one of those places it has this direction as it is seen, from up, to the
// left positive; it stays what it is at the next places. The sheet bends with it: its lines cross
// it where they did and reach as far, and stems that stand on it stay as they are at its side. Its
// foot stays, and so does its length. Fails, as the user's fault, for a line that is no stem, and
// where the sketch would give no plant.
Result<PenSketch> with_heading(PenSketch sketch, scene::ItemId stem, std::size_t place,
                               double heading_deg);

} // namespace tractus::lines
