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

// Shared by travel_fit.h and latency_fit.h: a pen that touches while the carriage moves.

// Where the pen's nib touched the tablet, the tablet's turn and centre taken off: world frame at
// height zero, before the carriage's travel. Times are as the rig has them told, less its tablet
// latency.
struct TouchPoint {
    Timestamp time {};
    Vec2 position_mm = Vec2::Zero();
};

std::vector<TouchPoint> touch_points(std::span<drivers::PenSample const> pens, Rig const& rig);

// The heights by the rig's model, at times as the rig has them told, less its height latency.
// Readings of another converter and readings that the model has no height for are left out.
HeightTrack height_track(std::span<drivers::HeightSample const> heights, Rig const& rig);

// The height at an instant between two readings; no value elsewhere.
std::optional<double> height_between(HeightTrack const& track, Timestamp time);

// Names for a time the stretch of half a second in which it lies: longer than a hand's tremor
// remembers, see least_squares.h.
int stretch_of(Timestamp time);

} // namespace tractus::calib
