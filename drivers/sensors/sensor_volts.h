#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tractus::drivers {

// The voltage of a reading, for converters with a reference of known voltage. It is kept in
// DeviceInfo::name, so that logs contain it too.

// Prints "0.002 V per count from 0 V", to be appended to a name.
std::string print_volts_per_count(double volts_per_count, double volts_at_zero);

// Returns the voltage at `counts`. No value if the name does not contain it, as with converters
// that measure relative to their own supply.
std::optional<double> sensor_volts(std::string_view name, double counts);

} // namespace tractus::drivers
