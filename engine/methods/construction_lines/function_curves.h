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

// Maximum length of a stem's pieces, as a share of its length: for stems with corners or tight
// bends, and for others. Shorter pieces would be too close to the plateaus of nodes.
constexpr double kShortPiece = 0.012;
constexpr double kLongPiece = 0.02;

// Number of functions before those of sizes around the stem.
constexpr std::size_t kFunctionsOfSides = 7;

// Returns the functions of a construction in the order in which models number them: heading, depth
// (the stem's pitch), angle_left, angle_right, size_left, size_right; internode, the distance to
// the next node; and, if there are boundaries in space, size_around_1 and so on, the sizes at the
// azimuths of Construction::around.
//
// cpfg evaluates a curve only to 0.001 in x. So each value that a node needs has a small plateau
// around it, and no precision is lost. Between nodes heading and depth are those of the stem's
// course. If nodes are too close for plateaus the course is used everywhere, with the organs'
// angles relative to it, since on a stem of few points it differs from the tangent.
std::vector<FunctionCurve> function_curves(Construction const& construction);

// Returns the curve as a function file of cpfg, with each control point repeated three times, which
// makes its B-spline straight between points.
std::string function_file(FunctionCurve const& curve);

} // namespace tractus::lines
