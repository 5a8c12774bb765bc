#pragma once

#include "app/devices/live_devices.h"

#include <string>
#include <vector>

namespace tractus::devices {

// Says on standard error which devices go away and come back, once each time.
class DeviceNews {
public:
    explicit DeviceNews(LiveDevices const& devices)
        : told_(devices.infos().size())
    {
    }

    // Tells what has changed since the last call.
    void tell(LiveDevices const& devices);

private:
    // News of a device that has been told.
    struct Told {
        LiveDevices::State state = LiveDevices::State::Connected;
        std::string refusal {};
    };

    std::vector<Told> told_;
};

} // namespace tractus::devices
