#pragma once

#include "drivers/pens/pen_fields.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tractus::drivers {

// State that a format's reports leave to be remembered from one to the next. Each device has its
// own.
struct FamilyState {
    std::uint32_t tool_serial = 0;
    std::uint32_t tool_type = 0;
    std::uint32_t buttons = 0;
    bool is_eraser = false;
    bool is_pen = true;     // False for a mouse on the tablet.
    bool is_inside = false; // The pen is in range.

    std::size_t frame = 0; // The state of a report that is asked for; see PenFamily::frames.

    std::int32_t x_maximum = 0; // The tablet's, which does not change; 0: not known.

    // The tool has left, and the next may be another.
    void forget_tool() { *this = { .x_maximum = x_maximum }; }
};

// One report format of a maker's own, which no report descriptor tells; many tablets share each.
// Sizes and maxima are the tablet's, not the format's: see TabletShape.
struct PenFamily {
    std::string_view name; // "wacom-intuos4".

    // A pure function. `report` begins with its report id and may be of any length. No value if it
    // is too short, or none of the pen's.
    std::optional<PenFields> (*decode)(std::span<std::byte const> report, FamilyState& state)
        = nullptr;

    bool has_tilt = false;
    bool has_eraser = false;
    bool reports_leaving = true; // See PenHabits.
    unsigned button_count = 2;
    std::int32_t touch_above = 0; // See PenScale.

    // How many states of the pen a report has room for, oldest first; FamilyState::frame chooses
    // one. The tablet measures them `frame_interval` apart, and says no more of their times.
    std::size_t frames = 1;
    Duration frame_interval {};
};

// Returns all formats that are known. Their names are unique.
std::span<PenFamily const> pen_families();

// Null if there is none of that name.
PenFamily const* find_pen_family(std::string_view name);

} // namespace tractus::drivers
