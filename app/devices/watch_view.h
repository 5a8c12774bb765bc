#pragma once

#include "app/diagnosis/device_monitor.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::devices {

// Lines that `tractus watch` shows at one moment, in a terminal as in plain output: for each device
// its name, its pace, and its latest bytes beside their meaning. No line is longer than `width`
// characters (at least 20).
std::vector<std::string> watch_lines(std::span<diagnosis::DeviceReading const> readings,
                                     std::size_t width);

// Describes the regularity of a device's reports: "200.0/s  every 5.00 ms  jitter 0.12 ms …", or
// that it is silent or disconnected.
std::string describe_pace(diagnosis::DeviceReading const& reading);

} // namespace tractus::devices
