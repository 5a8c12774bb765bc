#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// The formats of VEIKK and Acepen tablets: "veikk…" and "acepen". Byte 1 says what reports: 41 the
// pen, 42 keys, 43 a touch pad; the pen's flags are in byte 2.
std::span<PenFamily const> veikk_families();

} // namespace tractus::drivers
