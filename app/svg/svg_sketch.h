#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::svg {

// A line of an SVG drawing, upright and in millimetres.
struct SvgLine {
    std::string role; // Role of the line; empty if the drawing states none.
    std::vector<Vec2> points_mm;
};

// Reads the paths, polylines and straight lines of an SVG drawing in document order. `roles`
// contains lower-case words. A line has a role if its id, class or Inkscape label, or that of a
// group around it, begins with the role's word. Fails with a user error for invalid SVG, an invalid
// path, and a drawing without lines.
Result<std::vector<SvgLine>> read_svg_lines(std::string_view text,
                                            std::vector<std::string> const& roles);

// Converts the paths, polylines and straight lines of an SVG drawing to a sketch in JSON
// (line_sketch_file.h), upright and in millimetres. A line has a role if its id, class or Inkscape
// label, or that of a group around it, begins with the role's word: stem, left, right, inclination;
// or another, for an additional stem, to which the following lines belong. If no line has a role,
// all are strokes in document order; otherwise lines without a role are left out. Fails with a user
// error for invalid SVG, an invalid path, and a drawing without lines.
Result<nlohmann::json> svg_as_sketch(std::string_view text);

} // namespace tractus::svg
