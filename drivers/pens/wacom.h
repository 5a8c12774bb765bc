#pragma once

#include "drivers/pens/families.h"

namespace tractus::drivers {

// Wacom's formats, from the PenPartner of 1998 to the Intuos Pro of 2025. A tablet sends them when
// its mode is set, which Linux's driver does.
//
// The names "wacom-driver-…" are the same formats behind one byte that another system's driver puts
// before each report.
std::span<PenFamily const> wacom_families();

} // namespace tractus::drivers
