#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// Content of one pen report in device counts. A member without a value was not in the report;
// PenState fills it in.
struct PenFields {
    // Position in counts; y from the far edge towards the user. Ignored if `carries_position` is
    // false.
    bool carries_position = true;
    std::int32_t x = 0;
    std::int32_t y = 0;

    // Pressure in counts. No value: unchanged since the previous report.
    std::optional<std::int32_t> pressure {};

    // Tilt to the right and towards the user, from upright. No value: unchanged since the previous
    // report.
    std::optional<Vec2> tilt_deg {};

    // True if the pen is in range. No value: true, because the pen reports.
    std::optional<bool> in_range {};
    // True if the pen's tip is down. No value: derived from the pressure.
    std::optional<bool> tip {};
    // True if the eraser end points at the tablet. If `tip` is set too, the eraser is down.
    bool invert = false;
    bool eraser_touch = false; // True if the eraser end is down, regardless of `tip` and `invert`.
    std::uint32_t buttons = 0; // Bit 0: first barrel button, bit 1: second, …

    // Serial number and type of the pen; 0 if not in the report.
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;

    bool operator==(PenFields const&) const = default;
};

} // namespace tractus::drivers
