#pragma once

#include "engine/base/time.h"
#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// One state of a pen over a tablet.
//
// Tablet frame: millimetres, +x right, +y away from the user, origin at the active area's lower
// left corner.
struct PenSample {
    Timestamp time {}; // When the report arrived; the tablet's latency is still in it.
    Vec2 position_mm = Vec2::Zero();   // The last known position when the pen is out of range.
    std::optional<double> pressure {}; // 0 to 1; no value where the device does not say.
    std::optional<Vec2> tilt_rad {};   // Towards +x and towards +y from upright; no value where the
                                       // device does not say.
    bool in_range = false;
    bool touching = false;     // Pen's or eraser's end is down; implies in_range.
    bool eraser = false;       // The eraser's end points at the tablet.
    std::uint32_t buttons = 0; // Bit 0: first barrel button, bit 1: second, …

    // Serial number and type of the pen, if the device tells them; else 0.
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;

    // Counts as the report had them, before scaling. y counts from the device's own origin (top,
    // usually).
    std::int32_t raw_x = 0;
    std::int32_t raw_y = 0;
    std::int32_t raw_pressure = 0;
};

} // namespace tractus::drivers
