#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::calib {

// Places of a pen that move with something measured beside them: with the height along an upright
// edge (travel_fit.h), with the pen's lean (tilt_fit.h).
struct PlaneSighting {
    Vec2 position_mm = Vec2::Zero();
    Vec2 against = Vec2::Zero(); // Quantity that x goes with, and that y goes with.
    int stretch = 0;             // Stretch of time; see block_covariance of least_squares.h.
};

// Fitted: position = place + slope * (against - mean of all against), in x and in y.
struct PlaneLines {
    Vec2 place_mm = Vec2::Zero();
    Vec2 slope = Vec2::Zero();
    Vec2 slope_error = Vec2::Zero(); // Standard errors.
    double rms_mm = 0;               // Root mean square of the weighted distances.
    std::vector<Vec2> misses_mm {};  // Position less what was fitted, one per sighting.
};

// Least squares in which sightings far off count less, so that a pen that slips off for a moment
// does not spoil them (P. Huber, "Robust estimation of a location parameter", Ann. Math. Stat. 35,
// 1964). Standard errors take into account that a hand's tremor is no white noise. At least one
// sighting.
PlaneLines fit_plane_lines(std::span<PlaneSighting const> sightings);

} // namespace tractus::calib
