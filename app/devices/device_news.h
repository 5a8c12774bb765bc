#pragma once

#include "app/devices/live_devices.h"

#include <string>
#include <vector>

namespace tractus::devices {

// Prints a line on standard error whenever a device disconnects or reconnects.
class DeviceNews {
public:
    explicit DeviceNews(LiveDevices const& devices)
        : told_(devices.infos().size())
    {
    }

    // Prints the changes since the last call.
    void tell(LiveDevices const& devices);

private:
    // State of a device as last printed.
    struct PrintedState {
        LiveDevices::State state = LiveDevices::State::Connected;
        std::string refusal {};
    };

    std::vector<PrintedState> told_;
};

} // namespace tractus::devices
