#pragma once

#include "engine/base/vectors.h"

#include <optional>
#include <string_view>
#include <vector>

namespace tractus::svg {

// The lines of an SVG path's data (the attribute d; SVG 2, section 9.3), in its own units, y down:
// one for each move that draws something. Curves become polylines. No value if it is no path data.
std::optional<std::vector<std::vector<Vec2>>> parse_svg_path(std::string_view data);

// The points of a polyline's or polygon's attribute of this name.
std::optional<std::vector<Vec2>> parse_svg_points(std::string_view points);

} // namespace tractus::svg
