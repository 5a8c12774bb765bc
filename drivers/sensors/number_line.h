#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace tractus::drivers {

// Height sensors that tell a number in text: a line of a serial port, or a file of the kernel's
// industrial I/O. A report is the text, without its line break:
//
//   512        23.75        -3        height: 512        d=23.75 mm
//
// A name with a colon or an equals sign may stand before the number, and a unit behind it. A line
// that holds anything else is refused, so that what a board prints when it starts is no height.

// How such numbers become counts, from the words of DeviceInfo::settings.
struct NumberFormat {
    // Counts of the greatest number, from "max=4095" or "max=500.00": as many decimals as it has
    // are kept, so that 23.75 is 2375 counts there.
    std::int32_t full_scale = 4095;
    int decimals = 0;
};

// Reads "max=…"; no value for another word. Fails, as the user's fault, if the number is none, is
// not above 0, or has more than six decimals or 2,000,000,000 counts.
Result<std::optional<NumberFormat>> parse_greatest_number(std::string_view word);

// Decodes such reports. A little below 0, as differential converters read a short circuit, is 0.
// Decoding fails, as the device's fault, for other text, and for numbers above the greatest.
std::unique_ptr<HeightDecoder> make_number_decoder(NumberFormat format);

// What DeviceInfo::physical_path has of an opened sensor, since a log keeps it: a word for the kind
// of sensor, its address, and behind an @ its settings.
std::string number_line_path(std::string_view kind, DeviceInfo const& info);

// The settings of a device of that kind, live or from a log; no value for any other device.
std::optional<std::string> number_line_settings(std::string_view kind, DeviceInfo const& info);

} // namespace tractus::drivers
