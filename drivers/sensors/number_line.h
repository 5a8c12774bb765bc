#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace tractus::drivers {

// Height sensors that send a number as text: a line from a serial port, or a file of the kernel's
// industrial I/O. A report is the text without its line break:
//
//   512        23.75        -3        height: 512        d=23.75 mm
//
// A name with a colon or an equals sign may precede the number, and a unit may follow it. Any other
// line is refused, so that a board's start-up messages are not taken for heights.

// Conversion of a sensor's numbers into counts, set in DeviceInfo::settings.
struct NumberFormat {
    // Count that stands for the greatest number. "max=4095" or "max=500.00" also sets the decimals
    // that are kept: with two decimals, 23.75 is 2375 counts.
    std::int32_t full_scale = 4095;
    int decimals = 0;
};

// Parses a setting "max=…"; returns no value for any other word. Fails with a user error if the
// number is invalid, if it is not above 0, or if it has more than six decimals or exceeds
// 2,000,000,000 counts.
Result<std::optional<NumberFormat>> parse_greatest_number(std::string_view word);

// Makes the decoder for reports that contain a number. Values slightly below 0, which differential
// converters give for a short circuit, become 0. Decoding fails with a device error for other
// text, and for numbers above the maximum.
std::unique_ptr<HeightDecoder> make_number_decoder(NumberFormat format);

// Returns the path that is kept in DeviceInfo::physical_path, and so in logs, for an open sensor:
// its kind, its address and, after an @, its settings.
std::string number_line_path(std::string_view kind, DeviceInfo const& info);

// Returns the settings of a device of the given kind, live or from a log; no value for other
// devices.
std::optional<std::string> number_line_settings(std::string_view kind, DeviceInfo const& info);

} // namespace tractus::drivers
