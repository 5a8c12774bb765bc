#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <cstddef>
#include <string>
#include <vector>

namespace tractus::lines {

// A positional function as cpfg's function editor has it: a curve y(x) over x from 0 to 1, straight
// from point to point.
struct FunctionCurve {
    std::string name;         // What a model's file of it is called, such as heading.
    std::vector<Vec2> points; // At least 4, x rising from 0 to 1.
};

// At how many places a model is to tabulate them.
constexpr int kFunctionSamples = 4001;

// The longest pieces that a stem with corners or narrow bends is drawn in, and any other, by its
// length. Shorter ones would come too close to the plateaus of nodes.
constexpr double kShortPiece = 0.012;
constexpr double kLongPiece = 0.02;

// So many functions come before those of sizes around the stem.
constexpr std::size_t kFunctionsOfSides = 7;

// The functions of a construction in the order in which models number them: heading, depth (the
// stem's pitch), angle_left, angle_right, size_left, size_right; and internode, the way to the next
// node; then, where boundaries are in space, size_around_1 and so on, the sizes at the azimuths of
// Construction::around.
//
// cpfg finds a place on a curve only to 0.001. So each value that a node has to have stands on a
// small plateau around it, and nothing is lost. Between nodes heading and depth are the stem's
// course. Where nodes stand too close for plateaus they are so everywhere, and the organs' angles
// those to the course: on a stem of few points it differs from the tangent.
std::vector<FunctionCurve> function_curves(Construction const& construction);

// The curve as a file of cpfg's: each control point three times, which makes its B-spline straight
// from point to point.
std::string function_file(FunctionCurve const& curve);

} // namespace tractus::lines
