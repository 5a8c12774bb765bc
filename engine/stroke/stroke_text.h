#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Reads strokes from plain text: one tip per line, `x y z` in millimetres of the world frame,
// optionally followed by the pressure (0 to 1) and the time in milliseconds. Numbers are separated
// by spaces, commas or semicolons. An empty line ends a stroke; # begins a comment. Tips without
// time are placed 10 ms apart.
//
// Also reads the text that tilt2txt writes for VR sketches. In that text a stroke begins with a
// line `S points brush size`, lengths are in decimetres and y is up.
//
// Fails, in a sentence that begins with `name` and the line number, if the text has neither form, a
// number is not finite, or no stroke has two distinct points. Strokes with fewer than two are left
// out.
Result<std::vector<Stroke>> parse_strokes(std::string const& name, std::string_view text);

// Writes strokes as text, with pressure and time, for parse_strokes(). Each number has the fewest
// digits that read back as the same value; times are exact to the nanosecond as far as a double
// permits.
std::string print_strokes(std::span<Stroke const> strokes);

} // namespace tractus
