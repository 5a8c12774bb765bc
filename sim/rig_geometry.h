#pragma once

#include "calib/rig.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "sim/path.h"

#include <cstdint>

namespace tractus::sim {

// The true geometry of a simulated rig, which no calibration knows exactly. The string runs at an
// angle (see the drawing in height_model.h), so height is far from linear in counts.
struct RigGeometry {
    Vec2 tablet_size_mm = Vec2(254, 159);
    // Rotation of the tablet on its carriage, counterclockwise from above.
    double rotation_deg = 0;
    Vec2 travel_shear = Vec2::Zero(); // Drift towards +x and +y per millimetre of rise.
    double travel_mm = 400;           // Greatest height of the carriage; the lowest is 0.

    // Height of the pen's coil above its nib; the tablet reports the position below the coil.
    double coil_height_mm = 0;

    // Horizontal distance from the spool to the path of the string's end.
    double string_offset_mm = 120;
    // Vertical distance from the spool to the string's end at height zero.
    double string_base_mm = 80;
    double string_at_zero_counts_mm = 124;
    double string_per_count_mm = 0.1;
    std::int32_t full_scale_counts = 4095;
};

// Returns the length of string drawn out of the spool.
double string_length_mm(RigGeometry const& geometry, double height_mm);

// Returns the reading of an ideal converter: a real number, neither rounded nor clamped.
double ideal_counts(RigGeometry const& geometry, double height_mm);

// Returns the result of a perfect calibration; the caller fills in the latencies.
calib::Rig true_rig(RigGeometry const& geometry);

// Returns the transform from the tip's world position to (x, y, height): its position in the tablet
// frame, and the height of the carriage. The inverse of calib's T_world_tablet().
Eigen::Affine3d T_tablet_world(RigGeometry const& geometry);

// Fails with a user error that names the first position outside the rig's reach: off the tablet or
// beyond the travel, with a margin of 1 mm for the hand's tremor.
Result<void> check_reach(RigGeometry const& geometry, Path const& path);

} // namespace tractus::sim
