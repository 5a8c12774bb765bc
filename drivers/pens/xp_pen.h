#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// The formats of XP-Pen, and of UGEE, Parblo, Xencelabs and XENX tablets: "xp-pen…", "xencelabs"
// and "xenx". They come in 8 to 14 bytes, the longer with tilt and with more bits of what the
// shorter have.
std::span<PenFamily const> xp_pen_families();

} // namespace tractus::drivers
