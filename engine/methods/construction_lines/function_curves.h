#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::lines {

// A positional function in the form of cpfg's function editor: a polyline y(x) for x from 0 to 1.
struct FunctionCurve {
    std::string name;         // Name of the function's file in the model, such as heading.
    std::vector<Vec2> points; // Points, at least 4, with x ascending from 0 to 1.
};

// Number of samples at which a model tabulates its functions.
constexpr int kFunctionSamples = 4001;

// Maximum length of the pieces of which a model draws a stem, as a share of the stem's length:
// kShortPiece for stems with corners or tight bends, kLongPiece for others. If pieces were shorter,
// their midpoints could lie on the plateaus around nodes (function_curves()).
constexpr double kShortPiece = 0.012;
constexpr double kLongPiece = 0.02;

// Number of functions that precede the sizes around the stem in function_curves().
constexpr std::size_t kFunctionsOfSides = 7;

// Returns the functions of a construction in the order in which models number them: heading, depth
// (the stem's pitch), angle_left, angle_right, size_left, size_right; internode, the distance to
// the next node; and, if there are boundaries in space, size_around_1 and so on, the sizes at the
// azimuths of Construction::around.
//
// cpfg evaluates a curve only to 0.001 in x. Therefore the curve has a small plateau around each
// node, so that the node gets its exact value. Between nodes heading and depth are those of the
// stem's course (DrawnStem::course()). If nodes are too close for plateaus, the course is used
// everywhere, and the organs' angles are relative to it: on a stem of few points the course differs
// from the tangent.
std::vector<FunctionCurve> function_curves(Construction const& construction);

// Returns the curve as a function file of cpfg, with each control point repeated three times, which
// makes its B-spline straight between points.
std::string function_file(FunctionCurve const& curve);

} // namespace tractus::lines
