#pragma once

#include "drivers/pens/pen_state.h"

#include <cstdint>

namespace tractus::drivers {

// Buttons and ends of a pen, as a report descriptor says.
struct PenButtons {
    bool has_second = false;         // A second barrel button, under whatever name.
    bool has_second_by_name = false; // Under its own.
    bool has_second_as_tip = false;  // A secondary tip switch, under no other name.
    bool has_eraser = false;
    bool has_invert = false;
};

// Our own pen that is a mouse: its product id, of vendor 0.
inline constexpr std::uint16_t kMousePenProduct = 3;

// Returns what is known of pens whose report descriptor misleads; the default for all others.
//
// Linux can put such a descriptor right ("HID-BPF"): one that names a second barrel button has
// been, and needs no habits. A pen that has one button and an eraser, but cannot be turned round,
// has two buttons and no eraser: XP-Pen's and UGEE's are all so. Huion's and Gaomon's declare a
// secondary tip switch that none of them ever sends; their upper button is the eraser's bit all the
// same.
PenHabits known_habits(std::uint16_t vendor_id, std::uint16_t product_id,
                       PenButtons const& buttons);

} // namespace tractus::drivers
