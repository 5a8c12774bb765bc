#pragma once

#include "engine/base/time.h"

#include <memory>

namespace tractus::drivers {

// Notifies that devices were added or changed, so that waiting code need not poll. It does not say
// which device; see list_devices().
class DeviceEvents {
public:
    virtual ~DeviceEvents() = default;

    // True as soon as something was added or changed since the previous call, or since
    // construction; false after `timeout`, which may be 0. Events in quick succession are merged.
    virtual bool wait(Duration timeout) = 0;
};

// Listens to udev's events for HID nodes and USB devices, after udev's rules have set their
// permissions. Null if no udev daemon runs, as in many containers and small systems, or if the
// kernel refuses the socket. Converters on GPIO lines send no events.
std::unique_ptr<DeviceEvents> listen_to_udev();

} // namespace tractus::drivers
