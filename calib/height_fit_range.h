#pragma once

#include "calib/height_capture.h"
#include "calib/height_fit.h"
#include "calib/rig.h"
#include "engine/base/result.h"

#include <span>

namespace tractus::calib {

// Checks that a fit is usable for drawing: between the captures that were used, its law gives a
// height for each reading and rises or falls throughout; it extends beyond either end by a tenth of
// their span; and its standard error is at most 3 mm (more if the ruler's error exceeds 0.6 mm).
// Fails with a user error that says what to do.
Result<void> check_range(HeightFit const& fit, std::span<HeightCapture const> captures,
                         HeightFitOptions const& options);

// Checks that a rig's model gives heights that rise or fall throughout its calibrated readings.
// Fails with a user error that names the reading where they do not.
Result<void> check_calibrated_range(Rig const& rig);

} // namespace tractus::calib
