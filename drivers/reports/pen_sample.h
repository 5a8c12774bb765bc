#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// State of a pen over a tablet at one time.
//
// Tablet frame: millimetres, +x right, +y away from the user, origin at the lower left corner of
// the active area.
struct PenSample {
    Timestamp time {}; // Arrival time of the report; the tablet's latency is not subtracted.
    Vec2 position_mm = Vec2::Zero(); // Position; while the pen is out of range, the last known one.
    // Pressure from 0 to 1; no value if the device does not report it.
    std::optional<double> pressure {};
    // Tilt from upright towards +x and +y; no value if the device does not report it.
    std::optional<Vec2> tilt_rad {};
    bool in_range = false;
    bool touching = false;     // The pen's tip or its eraser is down; implies in_range.
    bool eraser = false;       // The eraser end points at the tablet.
    std::uint32_t buttons = 0; // Bit 0: first barrel button, bit 1: second, …

    // Serial number and type of the pen; 0 if the device does not report them.
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;

    // The report's counts before scaling. raw_y counts from the device's own origin, which is
    // usually the top.
    std::int32_t raw_x = 0;
    std::int32_t raw_y = 0;
    std::int32_t raw_pressure = 0;
};

} // namespace tractus::drivers
