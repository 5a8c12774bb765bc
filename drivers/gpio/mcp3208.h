#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <array>
#include <cstdint>
#include <functional>

namespace tractus::drivers {

// The MCP3008 (10 bits) and MCP3208 (12 bits), eight-channel converters, on four GPIO lines:
// bit-banged SPI mode 0,0 as in section 5 of Microchip's DS21295 and DS21298.
struct Mcp3208Wiring {
    // Line offsets on the GPIO chip, named after the converter's pins. DIN is the converter's data
    // input, so it is an output of the GPIO chip.
    unsigned clk = 0;
    unsigned din = 0;
    unsigned dout = 0;
    unsigned cs = 0;
};

// Bits of the converter's pins in GpioLines values, in the order of mcp3208_lines().
constexpr std::uint32_t kMcp3208Clk = 1;
constexpr std::uint32_t kMcp3208Din = 2;
constexpr std::uint32_t kMcp3208Dout = 4;
constexpr std::uint32_t kMcp3208Cs = 8;

// The lines in the order that convert_mcp3208() requires, initially with CS high and CLK low.
std::array<GpioLine, 4> mcp3208_lines(Mcp3208Wiring const& wiring);

struct Mcp3208Channel {
    unsigned bits = 12;   // Resolution: 12, or 10 for an MCP3008.
    unsigned channel = 0; // Number of the input, 0 to 7; it is single-ended.
};

// Result of one conversion.
struct Mcp3208Reading {
    std::int32_t counts = 0;
    // False if DOUT was high where the converter sends a zero, so nothing drives the line.
    bool is_answered = false;
    Timestamp sampled {}; // Time at which the converter stopped sampling.
    Duration held {};     // Longest possible time from the end of sampling to the last bit.
};

// Longest acceptable time between sampling and the last bit, because the hold capacitor leaks
// (DS21298, section 6.2). A conversion that the scheduler interrupted for longer reads too low and
// must be repeated.
constexpr Duration kMcp3208HoldLimit = std::chrono::microseconds(1200);

// Makes one conversion, in 51 kernel requests. `now` is a monotonic clock. Fails if the lines fail.
Result<Mcp3208Reading> convert_mcp3208(GpioLines& lines, Mcp3208Channel const& channel,
                                       std::function<Timestamp()> const& now);

} // namespace tractus::drivers
