#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// Report formats of XP-Pen, UGEE, Parblo, Xencelabs and XENX tablets: "xp-pen…", "xencelabs" and
// "xenx". Reports have 8 to 14 bytes; longer ones add tilt and further bits of position and
// pressure.
std::span<PenFamily const> xp_pen_families();

} // namespace tractus::drivers
