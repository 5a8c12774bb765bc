#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tractus::drivers {

// Meaning of a reading in volts, for converters whose reference is a voltage. It stands in the name
// of the device (DeviceInfo::name), so that a log tells it, too.

// "0.002 V per count from 0 V", to be put behind a name.
std::string print_volts_per_count(double volts_per_count, double volts_at_zero);

// Volts at `counts`; no value if the name does not tell, as that of a converter which measures what
// share of its own supply there is.
std::optional<double> sensor_volts(std::string_view name, double counts);

} // namespace tractus::drivers
