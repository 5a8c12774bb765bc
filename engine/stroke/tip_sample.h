#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <optional>

namespace tractus {

// The position and state of the pen's tip at one instant.
//
// World frame: right-handed, +x right, +y away from the user, +z up, origin on the desk under the
// tablet's centre at the rig's zero height, millimetres.
struct TipSample {
    Timestamp time {}; // Time of the sample; the tablet's latency is already subtracted.
    Vec3 position_mm = Vec3::Zero(); // Position of the tip, world frame.
    // Pressure from 0 to 1. If the tablet does not measure it, 1 while the tip touches.
    double pressure = 0;
    // Tilt of the pen from upright, towards +x and +y of the world. No value if the tablet does not
    // report tilt.
    std::optional<Vec2> tilt_rad {};
    bool touching = false; // True while the tip, or the eraser end, is on the tablet.
    bool eraser = false;   // True if the eraser end of the pen is used.

    // How the height was determined.
    enum class HeightSource {
        Interpolated, // Interpolated between two height readings; final.
        // Extrapolated from the last height reading, for live ink; replaced when later readings
        // arrive.
        Extrapolated,
    };
    HeightSource height_source = HeightSource::Interpolated;

    // True if the surface was above or below the calibrated range, so that the height is a guess.
    bool outside_calibration = false;
};

} // namespace tractus
