#pragma once

#include "drivers/pens/families.h"

namespace tractus::drivers {

// Wacom's report formats, from the PenPartner of 1998 to the Intuos Pro of 2025. A tablet sends
// them after its mode was switched, as Linux's driver does.
//
// The formats named "wacom-driver-…" have one extra byte in front, added by another operating
// system's driver.
std::span<PenFamily const> wacom_families();

} // namespace tractus::drivers
