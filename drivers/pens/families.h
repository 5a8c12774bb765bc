#pragma once

#include "drivers/pens/pen_fields.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tractus::drivers {

// State that a decoder keeps between the reports of one device.
struct FamilyState {
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;
    std::uint32_t buttons = 0;
    bool is_eraser = false;
    bool is_pen = true;     // True for a pen, false for a mouse on the tablet.
    bool is_inside = false; // True while the pen is in range.

    // Index of the pen state to decode, in a report that contains several; see PenFamily::frames.
    std::size_t frame = 0;

    // The tablet's maximum x in counts; 0 if not known. It never changes.
    std::int32_t x_maximum = 0;

    // Resets the state when a pen or mouse leaves, since the next one may be different.
    void forget_tool() { *this = { .x_maximum = x_maximum }; }
};

// A maker's own report format, which no report descriptor describes. Many tablets share one format;
// sizes and maxima belong to the tablet (TabletShape).
struct PenFamily {
    std::string_view name; // Unique name, such as "wacom-intuos4".

    // Decodes a report, without side effects except on `state`. `report` begins with its report id
    // and may have any length. Returns no value if the report is too short or not about the pen.
    std::optional<PenFields> (*decode)(std::span<std::byte const> report, FamilyState& state)
        = nullptr;

    bool has_tilt = false;
    bool has_eraser = false;
    bool reports_leaving = true; // See PenHabits::reports_leaving.
    unsigned button_count = 2;
    std::int32_t touch_above = 0; // See PenScale::touch_above.

    // Number of pen states in one report, oldest first; FamilyState::frame selects one. The tablet
    // samples them `frame_interval` apart; reports contain no times.
    std::size_t frames = 1;
    Duration frame_interval {};
};

// Returns all known formats.
std::span<PenFamily const> pen_families();

// Returns the format with this name; null if there is none.
PenFamily const* find_pen_family(std::string_view name);

} // namespace tractus::drivers
