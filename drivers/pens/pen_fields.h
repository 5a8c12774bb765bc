#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <optional>

namespace tractus::drivers {

// Content of one report of a pen, as the device counts. Where a report does not say, the member has
// no value, and PenState knows what to make of that.
struct PenFields {
    // Counts; y from the far edge towards the user. Not looked at if the report has no place in it.
    bool carries_position = true;
    std::int32_t x = 0;
    std::int32_t y = 0;

    std::optional<std::int32_t> pressure {}; // Counts. No value: as in the report before.

    // Tilt to the right and towards the user, from upright. No value: as in the report before.
    std::optional<Vec2> tilt_deg {};

    std::optional<bool> in_range {}; // No value: a pen that is reported is in range.
    std::optional<bool> tip {};      // The pen's end is down. No value: the pressure tells.
    bool invert = false;       // The eraser's end points at the tablet; with `tip` it is down.
    bool eraser_touch = false; // The eraser's end is down, whatever `tip` and `invert` say.
    std::uint32_t buttons = 0; // Bit 0: first barrel button, bit 1: second, …

    // Serial number and type of the pen, if the report tells them; else 0.
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;

    bool operator==(PenFields const&) const = default;
};

} // namespace tractus::drivers
