#pragma once

#include "calib/height_capture.h"
#include "calib/height_fit.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <span>

namespace tractus::calib {

// Whether a fit may be drawn with: its law gives a height for each reading between the captures
// that were used, rises or falls with the readings all the way, goes on for a tenth of their span
// beyond either end, and is known to three millimetres between them (its standard error; more if
// the ruler is read worse than to 0.6 mm). Fails as the user's fault with what to do.
Result<void> check_range(HeightFit const& fit, std::span<HeightCapture const> captures,
                         HeightFitOptions const& options);

// Whether a rig's model gives heights that rise or fall all the way from the least to the greatest
// of its calibrated readings. Fails as the user's fault and says where it does not.
Result<void> check_calibrated_range(Rig const& rig);

} // namespace tractus::calib
