#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// The formats of UC-Logic's controllers and their kin, which tablets of Huion, Gaomon, Artisul,
// Monoprice and many others send after they were switched: "uclogic-…" and "huion-giano". Offsets
// below count from the report id.
//
// Reports of all of them begin alike: flags in byte 1, then X, Y and pressure, 16 bits each. Of the
// flags, bit 0 is the tip and bits 1 to 3 are buttons; the upper bits tell pen, pad keys and dials
// apart.
std::span<PenFamily const> uclogic_families();

} // namespace tractus::drivers
