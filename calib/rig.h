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

// Source of sample times for devices that do not report them. In both cases the latency is
// subtracted.
enum class SampleTimes {
    AsArrived, // Arrival times; also the meaning of rig files without this setting.
    Evened,    // Times by EvenTimes, which spreads the samples of a burst evenly.
};

// Calibration of one rig: converts the readings of its two sensors into a position in the world.
// rig_file.h stores it in a file. The default is a fictitious rig, for tests and for logs without a
// height sensor.
struct Rig {
    // Height sensor. Readings of a converter with another full scale are refused. Readings outside
    // the range in which the model was fitted are used, but the fuser marks the resulting tips,
    // since the height is extrapolated.
    HeightModel height_model = LinearHeight {};
    std::int32_t full_scale_counts = 4095;
    double calibrated_min_counts = 0;
    double calibrated_max_counts = 4095;
    // Delay from the surface being at a height to the arrival of the report.
    Duration height_latency {};

    // Tablet. Its rotation on the carriage is counterclockwise, seen from above. (In degrees,
    // because the file uses degrees, so that writing and reading a file is exact.)
    Vec2 tablet_size_mm = Vec2(254, 159); // Sides of the tablet's active area.

    // Active area measured by the user, for a tablet that does not report its size: pen positions
    // are scaled to it. tablet_size_mm is then equal to it.
    std::optional<Vec2> surface_mm {};
    // Delay from the pen being at a position to the arrival of the report.
    Duration tablet_latency {};
    double rotation_deg = 0;

    // Horizontal drift of the carriage towards +x and +y per millimetre of rise.
    Vec2 travel_shear = Vec2::Zero();

    // Pen. Pens that report no pressure draw wherever they touch.
    PressureResponse pressure {};

    // Height of the pen's coil, by which the tablet locates it, as seen along the tablet's x and
    // along its y: a leaning pen is reported beside its nib by this height times its lean
    // (lean_track.h). Zero for tablets that correct for it; negative for those that overcorrect, or
    // report the tilt with the opposite sign. Samples without a tilt are not corrected.
    Vec2 coil_height_mm = Vec2::Zero();
    Nib nib = Nib::Point; // Appearance of the ink.

    // Time source for both sensors. It affects the latencies, which are longer with bursts that are
    // not evened.
    SampleTimes sample_times = SampleTimes::AsArrived;

    // Longest time before and after a height reading for which it may be used.
    Duration max_height_age = std::chrono::milliseconds(50);

    // Origin and accuracy of these numbers.
    CalibrationRecord calibration {};
};

// The heights at the ends of a rig's calibrated range, the lower one first, whichever way the
// sensor counts. No value if the model has no height there.
struct HeightRange {
    double low_mm = 0;
    double high_mm = 0;
};
std::optional<HeightRange> calibrated_heights(Rig const& rig);

// Limits for the sides of a tablet's active area.
inline constexpr double kMinSurfaceSide_mm = 20;
inline constexpr double kMaxSurfaceSide_mm = 2000;
inline bool is_tablet_area(Vec2 const& sides_mm)
{
    return sides_mm.minCoeff() >= kMinSurfaceSide_mm && sides_mm.maxCoeff() <= kMaxSurfaceSide_mm;
}

// Returns the transform of (x, y, height) to the world frame: x and y in the tablet frame, height
// above the carriage's zero, all in millimetres. The tablet rotates about its centre, which is over
// the world's origin at height zero.
Eigen::Affine3d T_world_tablet(Rig const& rig);

} // namespace tractus::calib
