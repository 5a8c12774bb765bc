#pragma once

#include "engine/base/time.h"

#include <memory>

namespace tractus::drivers {

// Tells that devices have come or changed, so that nobody who waits for one has to look again and
// again. What came, and whether it is the one that is wanted, is for list_devices() to say.
class DeviceEvents {
public:
    virtual ~DeviceEvents() = default;

    // True as soon as something has come or changed since the last call, or since this was made;
    // false after `timeout`, which may be 0. Events that come close together count once.
    virtual bool wait(Duration timeout) = 0;
};

// Listens to the events of udev's daemon: HID devices' nodes and USB devices, once udev's rules
// have given them their permissions. Null where no daemon runs, as in many containers and small
// systems, or the kernel gives no socket. Converters on GPIO lines send no events.
std::unique_ptr<DeviceEvents> listen_to_udev();

} // namespace tractus::drivers
