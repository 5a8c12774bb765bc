#pragma once

#include "calib/rig.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <span>

namespace tractus::calib {

// The carriage's actual travel, fitted with a pen held against a vertical straight edge that stands
// on the desk: the pen's apparent drift over the tablet is the tablet's drift under the pen.
struct TravelFit {
    // See Rig::travel_shear: drift towards +x and +y per millimetre of rise.
    Vec2 shear = Vec2::Zero();
    Vec2 shear_error = Vec2::Zero(); // Standard errors of `shear`.

    // Angle between the carriage's path and the tablet's normal.
    double tilt_rad = 0;
    double tilt_error_rad = 0;

    double rise_mm = 0; // Height from the lowest to the highest touch.
    double rms_mm = 0;  // Root mean square distance of the pen from the edge.
    std::size_t touches = 0;
};

// Fits the shear to the samples of pen and height sensor, with the rig's height model and
// latencies. An inclined edge cannot be distinguished from an inclined carriage: an inclination of
// 1 mm in 500 mm changes the shear by 0.002.
//
// A pen that slips off for a moment has little effect, and the standard errors allow for the time
// correlation of a hand's tremor (fit_plane_lines()).
//
// Fails with a user error that says what to do: fewer than 100 touches with a height, less than 100
// mm of rise, a pen that strayed by more than 3 mm on average.
Result<TravelFit> fit_travel(std::span<drivers::PenSample const> pens,
                             std::span<drivers::HeightSample const> heights, Rig const& rig);

} // namespace tractus::calib
