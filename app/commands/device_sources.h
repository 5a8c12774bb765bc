#pragma once

#include "app/devices/live_devices.h"
#include "engine/base/result.h"

#include <atomic>
#include <string>
#include <vector>

namespace tractus::commands {

// Opens what a command reads: the devices and logs that were named, or else every pen and height
// sensor that is found. Says on standard error what did not go well (DeviceInfo::warnings). Fails,
// as the user's fault, if none was named and none is found; `purpose` says what for, such as "to
// record".
Result<devices::LiveDevices> open_devices(std::vector<std::string> const& names,
                                          std::string const& purpose);

// Opens the devices that can be opened; the others are named on standard error. Fails if none can,
// as the first of them does.
Result<devices::LiveDevices> open_found(std::vector<drivers::DeviceInfo> const& found);

// Set by SIGINT and SIGTERM from now on, in place of ending the program.
std::atomic<bool> const& stop_on_signals();

} // namespace tractus::commands
