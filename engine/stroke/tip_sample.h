#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <optional>

namespace tractus {

// Where the pen's tip was at one instant.
//
// World frame: right-handed, +x right, +y away from the user, +z up, origin on the desk under the
// tablet's centre at the rig's zero height, millimetres.
struct TipSample {
    Timestamp time {}; // When the pen was there: the tablet's latency is already taken off.
    Vec3 position_mm = Vec3::Zero(); // World frame.
    double pressure = 0;             // 0 to 1; 1 while touching where the tablet measures none.
    // Tilt of the pen from upright towards +x and towards +y of the world; no value where the
    // tablet tells none.
    std::optional<Vec2> tilt_rad {};
    bool touching = false; // The tip (or the eraser's end) is down.
    bool eraser = false;   // The eraser's end points at the tablet.

    // How the height was found.
    enum class HeightSource {
        Interpolated, // Between two readings: final.
        Extrapolated, // Carried on from the last one: for live ink, replaced when later readings
                      // come.
    };
    HeightSource height_source = HeightSource::Interpolated;

    // The carriage is higher or lower than it was ever calibrated: the height is a guess.
    bool outside_calibration = false;
};

} // namespace tractus
