#pragma once

#include "engine/stroke/stroke.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::scene {

// Functions that write phrases for describing edits to the user.

// Returns a count with its noun, such as "1 tip" or "2 tips".
std::string counted(std::size_t count, char const* what);

// Returns the numbers, counted from 1, as a list: "1, 2 and 3" for 0, 1 and 2.
std::string list_numbers(std::vector<std::size_t> const& numbers);

// Returns a phrase such as "120 tips, 240 mm in 1.2 s".
std::string describe_stroke(Stroke const& stroke);

} // namespace tractus::scene
