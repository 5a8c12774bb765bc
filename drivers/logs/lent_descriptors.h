#pragma once

#include "drivers/logs/log.h"

namespace tractus::drivers {

// Some tablets send the reports of their pen on one interface and describe them on another (XP-Pen
// Deco 01 v2: sent on interface 1, described on 2). The kernel drops such reports; usbhid-dump and
// libusb have them. Where none of the reports of a device that are in memory stand in its own
// descriptor, and all of them in that of another interface of the same tablet, that one takes the
// place of its own.
void lend_descriptors(Log& log);

} // namespace tractus::drivers
