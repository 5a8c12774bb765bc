#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_source.h"
#include "engine/base/result.h"

#include <memory>
#include <string_view>

namespace tractus::drivers {

// Microchip's MCP2221A, a ready-made USB chip with a 10-bit converter, as a height sensor: the
// wiper of a string potentiometer is connected to one of its pins (datasheet DS20005565).

// Voltage reference: the supply, or an internal voltage of 1.024 V, 2.048 V or 4.096 V.
enum class Mcp2221aReference { Supply, Volts1024, Volts2048, Volts4096 };

struct Mcp2221aOptions {
    int pin = 1; // Pin of the wiper: GP1, GP2 or GP3.
    // Voltage at full scale. With the potentiometer between the chip's supply and ground, drift of
    // the supply cancels only if the supply is the reference.
    Mcp2221aReference reference = Mcp2221aReference::Supply;
};

// Parses comma-separated options in any order, "GP2,4.096V"; an empty text gives the defaults.
// Fails with a user error for unknown words.
Result<Mcp2221aOptions> parse_mcp2221a_options(std::string_view settings);

// True if the ids are those of the chip as delivered; its ids can be reprogrammed.
bool is_mcp2221a(DeviceInfo const&);

// Opens the chip at `info.location`, a hidraw node, with the options in `info.settings`, makes the
// pin a converter input, and reads it 500 times a second: a report is the chip's 64-byte reply to
// its status command. The other pins are left unchanged. Other programs, and a kernel driver that
// leaves a hidraw node, can use the chip at the same time: replies to them are dropped, and if they
// change the settings, the settings are made again, since such a change also resets the reference.
//
// The name in info() contains the pin, which make_mcp2221a_decoder() reads, and, if the reference
// is a known voltage, the volts per count (drivers/sensors/sensor_volts.h).
//
// Fails with a user error if the node cannot be opened, and with a device error if the chip does
// not reply as an MCP2221A.
Result<std::unique_ptr<ReportSource>> open_mcp2221a(DeviceInfo info);

// Opens the chip over any link. Fails with a device error if it does not reply as an MCP2221A.
Result<std::unique_ptr<ReportSource>>
open_mcp2221a(DeviceInfo info, std::unique_ptr<PacketLink> link, Mcp2221aOptions const& options);

// Makes the decoder for the pin in the device's name (default: GP1), with counts of 0 to 1023.
// Decoding skips replies to other commands, and fails if the chip reports that a command failed, or
// if a reply is truncated.
Result<std::unique_ptr<HeightDecoder>> make_mcp2221a_decoder(DeviceInfo const&);

} // namespace tractus::drivers
