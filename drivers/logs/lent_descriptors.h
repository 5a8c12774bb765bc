#pragma once

#include "drivers/logs/log.h"

namespace tractus::drivers {

// Assigns report descriptors to the interfaces that send the reports. Some tablets send their pen's
// reports on one interface and describe them on another (XP-Pen Deco 01 v2: sent on interface 1,
// described on 2). The kernel drops such reports; usbhid-dump and libusb see them. If a device's
// own descriptor declares none of its reports that are in memory, and the descriptor of another
// interface of the same tablet declares all of them, the device gets that other descriptor.
void lend_descriptors(Log& log);

} // namespace tractus::drivers
