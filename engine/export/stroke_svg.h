#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <ostream>
#include <span>

namespace tractus::exports {

// Direction in which strokes are looked at, in parallel projection.
enum class StrokeView {
    Front, // The view of whoever draws: x to the right, z up.
    Side,  // The view from the right: what is away from the user is to the right, z up.
    Top,   // The view from above: x to the right, what is away from the user up.
};

// Writes strokes as an SVG 1.1 drawing at true scale: one polyline per stroke, in the order in
// which they were drawn, with ids "stroke-1" and so on, in numbers that are millimetres of the
// world frame (y turned round, since SVG's points down) with three decimals. The page ends 5 mm
// beside what is drawn. Lines are as wide as the pen was pressed on the average: 0.2 mm to 1 mm.
// Same input, same bytes. A stroke without two tips is left out, but keeps its number.
//
// Fails if the stream fails, or if a coordinate is not finite.
Result<void> write_strokes_svg(std::ostream& out, std::span<Stroke const> strokes, StrokeView view);

} // namespace tractus::exports
