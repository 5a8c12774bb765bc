#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// Report formats of UC-Logic's controllers and their relatives, which tablets by Huion, Gaomon,
// Artisul, Monoprice and many others send after their mode was switched: "uclogic-…" and
// "huion-giano". Offsets include the report id.
//
// All these reports begin alike: flags in byte 1, then X, Y and pressure, 16 bits each. Bit 0 of
// the flags is the tip and bits 1 to 3 are buttons; the upper bits distinguish pen, pad keys and
// dials.
std::span<PenFamily const> uclogic_families();

} // namespace tractus::drivers
