#pragma once

#include "calib/calibration_record.h"
#include "calib/height_model.h"
#include "calib/pressure_response.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"
#include "engine/stroke/nib.h"

#include <cstdint>
#include <optional>

namespace tractus::calib {

// When a sample is taken to have been there, of a device that does not tell. In both cases its
// latency is taken off.
enum class SampleTimes {
    AsArrived, // When it arrived. All that there was for rigs of files that do not say.
    Evened,    // As EvenTimes has it: what a burst brought was taken one after the other.
};

// Calibration of one rig: how its two sensors' readings become a place in the world. rig_file.h
// keeps it in a file. The default is a rig that exists nowhere, for tests and for logs without a
// height sensor.
struct Rig {
    // The height sensor. Its readings are refused if its converter's greatest reading is another
    // one. Readings outside the range in which the model was fitted are used, but the fuser marks
    // the tips that come of them, for they are guesses.
    HeightModel height_model = LinearHeight {};
    std::int32_t full_scale_counts = 4095;
    double calibrated_min_counts = 0;
    double calibrated_max_counts = 4095;
    Duration height_latency {}; // Time from the height's being so to its report's arrival.

    // The tablet. It is turned counterclockwise, seen from above, on its carriage. (In degrees
    // since the file is, and its round trip is exact.)
    Vec2 tablet_size_mm = Vec2(254, 159); // Its active area.

    // The active area as somebody measured it, for a tablet that does not tell its size: what such
    // a tablet's pen is scaled to. Then tablet_size_mm is that, too.
    std::optional<Vec2> surface_mm {};
    Duration tablet_latency {}; // Time from the pen's being there to its report's arrival.
    double rotation_deg = 0;

    // How far the carriage drifts to +x and +y per millimetre that it rises.
    Vec2 travel_shear = Vec2::Zero();

    // The pen. Pens that report no pressure draw wherever they touch.
    PressureResponse pressure {};

    // How far up the pen what the tablet finds it by is, its coil, as seen along the tablet's x and
    // along its y: a pen that leans is reported that much times its lean (lean_track.h) beside its
    // nib. Zero for tablets that correct for it; negative where they correct for too much, or tell
    // the tilt the other way round. Samples without a tilt are left as they are.
    Vec2 coil_height_mm = Vec2::Zero();
    Nib nib = Nib::Point; // How its ink looks.

    // Of both sensors. It goes with the latencies, which bursts lengthen where they are not evened
    // out.
    SampleTimes sample_times = SampleTimes::AsArrived;

    // How long one height reading stands for the height before and after it.
    Duration max_height_age = std::chrono::milliseconds(50);

    // How all this was found out, and how exactly.
    CalibrationRecord calibration {};
};

// The heights at the ends of a rig's calibrated range, the lower one first, whichever way the
// sensor counts. No value where the model has no height there.
struct HeightRange {
    double low_mm = 0;
    double high_mm = 0;
};
std::optional<HeightRange> calibrated_heights(Rig const& rig);

// The sides that a tablet's active area may have.
inline constexpr double kMinSurfaceSide_mm = 20;
inline constexpr double kMaxSurfaceSide_mm = 2000;
inline bool is_tablets_surface(Vec2 const& sides_mm)
{
    return sides_mm.minCoeff() >= kMinSurfaceSide_mm && sides_mm.maxCoeff() <= kMaxSurfaceSide_mm;
}

// Takes (x, y, height) to the world frame: x and y in the tablet frame, height over the carriage's
// zero, all in millimetres. The tablet turns about its centre, which is over the world's origin at
// height zero.
Eigen::Affine3d T_world_tablet(Rig const& rig);

} // namespace tractus::calib
