#pragma once

#include "app/devices/live_devices.h"
#include "engine/base/result.h"

#include <atomic>
#include <string>
#include <vector>

namespace tractus::commands {

// Opens the devices and logs that were named, by default every pen and height sensor found. Prints
// problems on standard error (DeviceInfo::warnings). Fails with a user error if none was named and
// none is found; `purpose` completes the message, such as "to record".
Result<devices::LiveDevices> open_devices(std::vector<std::string> const& names,
                                          std::string const& purpose);

// Opens all devices that can be opened and prints the others on standard error. If none can be
// opened, fails with the error of the first one.
Result<devices::LiveDevices> open_found(std::vector<drivers::DeviceInfo> const& found);

// Flag that SIGINT, SIGTERM and SIGHUP (unless ignored) set from now on, instead of ending the
// program.
std::atomic<bool> const& stop_on_signals();

} // namespace tractus::commands
