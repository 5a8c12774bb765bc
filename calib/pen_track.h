#pragma once

#include "calib/height_track.h"
#include "calib/rig.h"
#include "drivers/reports/height_sample.h"
#include "drivers/reports/pen_sample.h"
#include "engine/base/vectors.h"

#include <optional>
#include <span>
#include <vector>

namespace tractus::calib {

// Functions shared by travel_fit.h and latency_fit.h, for a pen that touches while the carriage
// moves.

// A touch of the pen's nib, with the tablet's rotation and centre applied: world frame at height
// zero, before the carriage's travel. Times are evened if the rig asks for it, minus the tablet's
// latency.
struct TouchPoint {
    Timestamp time {};
    Vec2 position_mm = Vec2::Zero();
};

std::vector<TouchPoint> touch_points(std::span<drivers::PenSample const> pens, Rig const& rig);

// Returns the heights by the rig's model, at times that are evened if the rig asks for it, minus
// the height latency. Readings of another converter and readings outside the model are left out.
HeightTrack height_track(std::span<drivers::HeightSample const> heights, Rig const& rig);

// Returns the height at an instant between two readings; no value elsewhere.
std::optional<double> height_between(HeightTrack const& track, Timestamp time);

// Returns the index of the half-second stretch of time that contains `time`. A stretch is longer
// than the correlation time of a hand's tremor, see least_squares.h.
int stretch_of(Timestamp time);

} // namespace tractus::calib
