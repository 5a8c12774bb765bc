#pragma once

#include "app/devices/live_devices.h"

#include <string>
#include <vector>

namespace tractus::devices {

// Prints on standard error when devices disconnect and reconnect, once for each event.
class DeviceNews {
public:
    explicit DeviceNews(LiveDevices const& devices)
        : told_(devices.infos().size())
    {
    }

    // Prints the changes since the last call.
    void tell(LiveDevices const& devices);

private:
    // Last printed state of a device.
    struct PrintedState {
        LiveDevices::State state = LiveDevices::State::Connected;
        std::string refusal {};
    };

    std::vector<PrintedState> told_;
};

} // namespace tractus::devices
