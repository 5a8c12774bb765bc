#pragma once

#include "app/diagnosis/device_monitor.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::devices {

// Returns what `tractus watch` shows at one moment, line by line, the same in a terminal's screen
// and in plain output: per device its name, its pace, and its newest bytes beside what they mean.
// No line is longer than `width` characters, at least 20.
std::vector<std::string> watch_lines(std::span<diagnosis::DeviceReading const> readings,
                                     std::size_t width);

// How regularly a device sends: "200.0/s  every 5.00 ms  jitter 0.12 ms …"; or that it is silent,
// or gone.
std::string describe_pace(diagnosis::DeviceReading const& reading);

} // namespace tractus::devices
