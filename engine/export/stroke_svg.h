#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Direction from which strokes are projected onto the page, in parallel.
enum class StrokeView {
    Front, // As seen by the user: x to the right, z up.
    Side,  // From the right: y (away from the user) to the right, z up.
    Top,   // From above: x to the right, y (away from the user) up.
};

// Writes strokes as an SVG 1.1 drawing at true scale: one polyline per stroke, in drawing order,
// with ids "stroke-1" and so on. Coordinates are millimetres of the world frame with three decimals
// (y is reversed, since SVG's y points down). The page has a margin of 5 mm. The line width of a
// stroke rises with its mean pressure, from 0.2 mm to 1 mm. The same strokes always give the same
// text. A stroke of fewer than two tips is left out, but the others keep their numbers.
//
// Fails if the stream fails or a coordinate is not finite.
Result<void> write_strokes_svg(std::ostream& out, std::span<Stroke const> strokes, StrokeView view);

} // namespace tractus::exports
