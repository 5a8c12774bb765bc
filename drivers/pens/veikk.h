#pragma once

#include "drivers/pens/families.h"

#include <span>

namespace tractus::drivers {

// Report formats of VEIKK and Acepen tablets: "veikk…" and "acepen". Byte 1 is the kind of report:
// 0x41 pen, 0x42 keys, 0x43 touch pad; the pen's flags are in byte 2.
std::span<PenFamily const> veikk_families();

} // namespace tractus::drivers
