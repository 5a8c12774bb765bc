#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Strokes from plain text: a tip per line, `x y z` in millimetres of the world frame, and if there
// are more numbers the pressure (0 to 1) and the time in milliseconds. Numbers are parted by
// blanks, commas or semicolons. A line that is empty ends a stroke; what follows a # is a comment.
// Tips without time are 10 ms apart.
//
// Text that tilt2txt writes of VR sketches is read, too: there a stroke begins with a line
// `S points brush size`, lengths are decimetres and y is up.
//
// Refuses, in a sentence that begins with `name` and the line's number, what is neither, numbers
// that are not finite, and a text without a stroke of two distinct points; shorter ones are left
// out.
Result<std::vector<Stroke>> parse_strokes(std::string const& name, std::string_view text);

// Writes the text of strokes, with pressure and time, so that parse_strokes() reads it back: each
// number as short as it can be without another one's being read, and times to the nanosecond as far
// as a double holds them.
std::string print_strokes(std::span<Stroke const> strokes);

} // namespace tractus
