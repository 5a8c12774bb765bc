#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

namespace tractus {

// Redraws a part of a stroke. `over` begins and ends on the drawn stroke, in either direction, and
// replaces the part between. If only its beginning is within `finger_mm` of the drawn stroke, it
// replaces everything from there to the stroke's end; if only its end is, everything from the
// stroke's beginning to there. The new part is shifted to join the stroke without a gap; the shift
// fades with the distance from the joint. Tips stay in time order.
//
// Fails, in one sentence, if a stroke has no direction (stroke_points) or neither end of `over` is
// near the drawn stroke.
Result<Stroke> oversketch(Stroke const& drawn, Stroke over, double finger_mm = 20);

} // namespace tractus
