#pragma once

#include "calib/rig.h"
#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "sim/path.h"

#include <cstdint>

namespace tractus::sim {

// A rig as it stands there, in bodies and distances, as no calibration ever knows it. The string
// runs aslant (height_model.h has the drawing), so that height is far from linear in counts.
struct RigGeometry {
    Vec2 tablet_size_mm = Vec2(254, 159);
    // Rotation of the tablet on its carriage, counterclockwise from above.
    double rotation_deg = 0;
    Vec2 travel_shear = Vec2::Zero(); // Drift to +x and +y per millimetre of rise.
    double travel_mm = 400;           // The carriage goes from height 0 to here.

    // How far above its nib the pen's coil is, over which the tablet says that the pen is.
    double coil_height_mm = 0;

    // Distance from the spool across to the way of the string's end.
    double string_offset_mm = 120;
    double string_base_mm = 80; // Distance from the spool up to the string's end at height zero.
    double string_at_zero_counts_mm = 124;
    double string_per_count_mm = 0.1;
    std::int32_t full_scale_counts = 4095;
};

// Length of string out of the spool.
double string_length_mm(RigGeometry const& geometry, double height_mm);

// Returns what an ideal converter would read: a real number, neither rounded nor clamped.
double ideal_counts(RigGeometry const& geometry, double height_mm);

// Returns what a perfect calibration of the rig would find; the latencies are the caller's to fill
// in.
calib::Rig true_rig(RigGeometry const& geometry);

// Takes a place of the tip in the world to (x, y, height): where on the tablet it is, in the tablet
// frame, and how high the carriage. The inverse of calib's T_world_tablet.
Eigen::Affine3d T_tablet_world(RigGeometry const& geometry);

// Fails, as the user's fault, with the first place that the rig cannot reach: off the tablet or
// beyond the travel, a millimetre kept for the hand's tremor.
Result<void> check_reach(RigGeometry const& geometry, Path const& path);

} // namespace tractus::sim
