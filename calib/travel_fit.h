#pragma once

#include "calib/rig.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// How the carriage really travels, from a pen held against a vertical straight edge that stands on
// the desk: what the pen seems to drift over the tablet, the tablet drifts under it.
struct TravelFit {
    Vec2 shear = Vec2::Zero(); // Rig::travel_shear: drift to +x and +y per millimetre of rise.
    Vec2 shear_error = Vec2::Zero(); // Standard errors.

    // Angle between the carriage's way and the tablet's normal.
    double tilt_rad = 0;
    double tilt_error_rad = 0;

    double rise_mm = 0; // Rise between the lowest and the highest touch.
    double rms_mm = 0;  // Root mean square by which the pen strayed from the edge.
    std::size_t touches = 0;
};

// Fits the shear to what pen and height sensor sent meanwhile, with the rig's height model and
// latencies. An edge that leans is not told from a carriage that does: 1 mm in 500 is 0.002.
//
// A pen that slips off for a moment does not spoil it, and standard errors take into account that a
// hand's tremor is no white noise (fit_plane_lines).
//
// Fails, as the user's fault, with what to do: fewer than 100 touches with a height, less than 100
// mm of rise, a pen that strayed by more than 3 mm in the mean.
Result<TravelFit> fit_travel(std::span<drivers::PenSample const> pens,
                             std::span<drivers::HeightSample const> heights, Rig const& rig);

} // namespace tractus::calib
