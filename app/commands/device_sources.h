#pragma once

#include "app/devices/live_devices.h"
#include "engine/base/result.h"

#include <atomic>
#include <string>
#include <vector>

namespace tractus::commands {

// Opens the devices and logs in `names`. If `names` is empty, opens every pen and height sensor
// found. Prints problems (DeviceInfo::warnings) on standard error. Fails with a user error if
// `names` is empty and no device is found; `purpose` completes its message, such as "to record".
Result<devices::LiveDevices> open_devices(std::vector<std::string> const& names,
                                          std::string const& purpose);

// Opens all devices of `found` that can be opened and prints errors of the others on standard
// error. If none can be opened, fails with the error of the first one.
Result<devices::LiveDevices> open_found(std::vector<drivers::DeviceInfo> const& found);

// From now on, SIGINT, SIGTERM and (unless it is ignored) SIGHUP set the returned flag instead of
// ending the program.
std::atomic<bool> const& stop_on_signals();

} // namespace tractus::commands
