#pragma once

#include "drivers/pens/pen_state.h"

#include <cstdint>

namespace tractus::drivers {

// Buttons and ends that a pen's report descriptor declares.
struct PenButtons {
    bool has_second = false;         // A second barrel button, declared by any usage.
    bool has_second_by_name = false; // A second barrel button, declared by its own usage.
    // A secondary tip switch, and no other usage for a second button.
    bool has_second_as_tip = false;
    bool has_eraser = false;
    bool has_invert = false;
};

// Product id, with vendor id 0, of a mouse used as a pen.
inline constexpr std::uint16_t kMousePenProduct = 3;

// Returns the known habits of a pen whose report descriptor is misleading, and default habits for
// all other pens.
//
// Linux can correct such a descriptor ("HID-BPF"). If a descriptor declares a second barrel button
// by its own usage, it has been corrected, and its pen needs no habits. A pen with one button and
// an eraser but no invert switch really has two buttons and no eraser; this is so for all pens by
// XP-Pen and UGEE. Huion and Gaomon declare a secondary tip switch that their pens never send; the
// upper button sends the eraser's bit instead.
PenHabits known_habits(std::uint16_t vendor_id, std::uint16_t product_id,
                       PenButtons const& buttons);

} // namespace tractus::drivers
