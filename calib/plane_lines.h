#pragma once

#include "engine/base/vectors.h"

#include <span>
#include <vector>

namespace tractus::calib {

// A pen position together with a quantity that it varies with: the height along an upright edge
// (travel_fit.h), or the pen's lean (tilt_fit.h).
struct PlaneSighting {
    Vec2 position_mm = Vec2::Zero();
    Vec2 against = Vec2::Zero(); // Quantities that the x and the y of the position vary with.
    int stretch = 0; // Number of the stretch of time; see block_covariance() in least_squares.h.
};

// Result of fitting position = place + slope * (against - mean of all against), separately for x
// and y.
struct PlaneLines {
    Vec2 place_mm = Vec2::Zero();
    Vec2 slope = Vec2::Zero();
    Vec2 slope_error = Vec2::Zero(); // Standard errors of `slope`.
    double rms_mm = 0; // Root mean square of the sightings' weighted distances from the fit.
    std::vector<Vec2> misses_mm {}; // Position minus fitted position, one for each sighting.
};

// Fits by least squares with less weight for distant sightings, so that a pen that slips off for a
// moment has little effect (P. Huber, "Robust estimation of a location parameter", Ann. Math. Stat.
// 35, 1964). The standard errors allow for the time correlation of a hand's tremor. Requires at
// least one sighting.
PlaneLines fit_plane_lines(std::span<PlaneSighting const> sightings);

} // namespace tractus::calib
