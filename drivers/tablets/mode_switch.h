#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/tablet_port.h"

namespace tractus::drivers {

// Whether Linux's own driver for the tablet has switched it already; the reports that switch are
// left out then, and nothing is warned of, since the driver's descriptor says all that matters.
enum class SwitchedBy { Nobody, Kernel };

// Finds out which tablet this is, and makes it leave the mode in which it powers up:
//
// 1. reads the strings that tell apart the tablets with its ids;
// 2. looks it up;
// 3. reads the strings, then sends the feature reports, then the output reports that the table
//    names for it, in the table's order.
//
// Strings that were read go to `info.strings`, an empty text for one that the tablet does not have.
// Failures go to `info.warnings`, one sentence for each of the three kinds at most; the tablet then
// stays in the mode it is in, and its decoder will be the one for that mode.
void switch_to_full_mode(DeviceInfo& info, TabletPort& port, SwitchedBy switched_by);

} // namespace tractus::drivers
