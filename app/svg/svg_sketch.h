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
    std::string role; // Empty: it does not say.
    std::vector<Vec2> points_mm;
};

// The paths, polylines and straight lines of an SVG drawing, in its order. A line's role is the one
// of `roles`, lower-case words, by which its id, class or label in Inkscape begins, or that of a
// group around it.
//
// Fails, as the user's fault: text that is no SVG, a path that cannot be read, no line at all.
Result<std::vector<SvgLine>> read_svg_lines(std::string_view text,
                                            std::vector<std::string> const& roles);

// The lines of an SVG drawing as a sketch in JSON (line_sketch_file.h), upright and in millimetres:
// paths, polylines and straight lines. What a line is says its id, class or label in Inkscape, or
// that of a group around it, by how it begins: stem, left, right, inclination; another, for
// another stem, to which the lines belong that follow it. Where none does, they are strokes in the
// drawing's order. Lines without such a word among others that have one are left out.
//
// Fails, as the user's fault: text that is no SVG, a path that cannot be read, no line at all.
Result<nlohmann::json> svg_as_sketch(std::string_view text);

} // namespace tractus::svg
