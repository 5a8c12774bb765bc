#pragma once

#include "app/diagnosis/device_monitor.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::devices {

// Returns the lines that `tractus watch` shows at a given moment, both in a terminal and as plain
// output. For each device they show its name, its pace, and the bytes of its latest report beside
// their meaning. No line is longer than `width` characters (at least 20).
std::vector<std::string> watch_lines(std::span<diagnosis::DeviceReading const> readings,
                                     std::size_t width);

// Describes the regularity of a device's reports, such as "200.0/s  every 5.00 ms  jitter 0.12 ms
// …", or says that the device is silent or disconnected.
std::string describe_pace(diagnosis::DeviceReading const& reading);

} // namespace tractus::devices
