#pragma once

#include "engine/base/vectors.h"

#include <optional>
#include <string_view>
#include <vector>

namespace tractus::svg {

// Parses SVG path data (attribute d; SVG 2, section 9.3) into lines in the path's own units, y
// down. There is one line for each move command that draws something. Curves become polylines. No
// value if the data is invalid.
std::optional<std::vector<std::vector<Vec2>>> parse_svg_path(std::string_view data);

// Parses the attribute "points" of a polyline or polygon. No value if it is invalid.
std::optional<std::vector<Vec2>> parse_svg_points(std::string_view points);

} // namespace tractus::svg
