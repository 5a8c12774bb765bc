#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

namespace tractus {

// Redraws a part of a stroke, as people do on paper: `over` begins and ends on the drawn stroke, in
// either direction, and takes the place of what lies between. Where only one of its ends is within
// `finger_mm` of the drawn stroke, it takes the place of all beyond: the stroke's rest, or its
// beginning. The new part is shifted so that it joins without a gap, the more the nearer to the
// joint. Tips stay in time order.
//
// Refuses, in a sentence, strokes that have no direction (stroke_points), and an `over` of which
// neither end is near.
Result<Stroke> oversketch(Stroke const& drawn, Stroke over, double finger_mm = 20);

} // namespace tractus
