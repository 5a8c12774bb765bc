#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>

namespace tractus::drivers {

// Microchip's MCP2221A, a finished USB chip with a converter of 10 bits: a string potentiometer's
// wiper on one of its pins is a height sensor (datasheet DS20005565).

enum class Mcp2221aReference { Supply, Volts1024, Volts2048, Volts4096 }; // 1.024 V, …

struct Mcp2221aOptions {
    int pin = 1; // Wiper on GP1, GP2 or GP3.
    // Voltage that full scale means. With the potentiometer between the chip's supply and ground,
    // only the supply lets its drift cancel.
    Mcp2221aReference reference = Mcp2221aReference::Supply;
};

// Options as words between commas, in any order: "GP2,4.096V"; none for the defaults. Fails, as the
// user's fault, for other words.
Result<Mcp2221aOptions> parse_mcp2221a_options(std::string_view settings);

// Whether the device is one, by its ids; the chip's maker lets others change them.
bool is_mcp2221a(DeviceInfo const&);

// Opens the chip at `info.location`, a hidraw node, with `info.settings` as options, makes the pin
// an input of the converter, and reads 500 times a second: a report is the chip's 64-byte answer to
// its status command. The other pins stay as they are. Other programs may go on using the chip,
// and the kernel's driver where it leaves a hidraw node at all: the answers to them are dropped,
// and the settings are made again when they have changed them, since that also changes the
// reference.
//
// The pin is added to the name in info(), where make_mcp2221a_decoder reads it, and what a count is
// in volts, where the reference tells (drivers/sensors/sensor_volts.h).
//
// Fails, as the user's fault, if the node cannot be opened, and as the device's, if the chip does
// not answer as such a chip does.
Result<std::unique_ptr<ReportSource>> open_mcp2221a(DeviceInfo info);

// Opens one over any link. Fails, as the device's fault, likewise.
Result<std::unique_ptr<ReportSource>>
open_mcp2221a(DeviceInfo info, std::unique_ptr<PacketLink> link, Mcp2221aOptions const& options);

// Counts of 0 to 1023 from the pin that the device's name tells, GP1 if it tells none. Decoding
// passes over the answers to other commands, and fails if the chip says that it could not do what
// it was told, or if an answer is cut off.
Result<std::unique_ptr<HeightDecoder>> make_mcp2221a_decoder(DeviceInfo const&);

} // namespace tractus::drivers
