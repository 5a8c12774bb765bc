#pragma once

#include "engine/stroke/stroke.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::scene {

// Words for what edits do.

// "1 tip", "2 tips".
std::string counted(std::size_t count, char const* what);

// "1, 2 and 3" for numbers that count from 0.
std::string list_numbers(std::vector<std::size_t> const& numbers);

// "120 tips, 240 mm in 1.2 s".
std::string describe_stroke(Stroke const& stroke);

} // namespace tractus::scene
