#pragma once

#include "drivers/pens/pen_state.h"

#include <cstdint>

namespace tractus {

// What is known of a model whose report descriptor misleads; the default for all others. Linux can
// put such a descriptor right ("HID-BPF"); a descriptor that names a second barrel button has been,
// and needs no habits.
PenHabits known_habits(std::uint16_t vendor_id, std::uint16_t product_id);

} // namespace tractus
