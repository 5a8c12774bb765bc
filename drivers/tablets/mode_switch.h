#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/tablet_port.h"

namespace tractus::drivers {

// Whether Linux's own driver has already switched the tablet's mode. In that case no switching
// reports are sent and no warnings are given, since the driver's descriptor is sufficient.
enum class SwitchedBy { Nobody, Kernel };

// Identifies the tablet and switches it from its power-up mode to its full mode:
//
// 1. reads the strings that distinguish tablets with these ids;
// 2. looks the tablet up in the table;
// 3. reads the strings, then sends the feature reports, then the output reports, that the table
//    lists for it, in the table's order.
//
// The strings are stored in `info.strings`, as an empty text if the tablet lacks one. Failures are
// stored in `info.warnings`, at most one sentence for each of the three kinds of steps. After a
// failure the tablet stays in its mode, and will be decoded as in that mode.
void switch_to_full_mode(DeviceInfo& info, TabletPort& port, SwitchedBy switched_by);

} // namespace tractus::drivers
