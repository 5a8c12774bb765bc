#pragma once

#include "drivers/gpio/gpio_lines.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <array>
#include <cstdint>
#include <functional>

namespace tractus::drivers {

// The MCP3008 (10 bits) and the MCP3208 (12 bits), converters of eight channels, on four GPIO
// lines: SPI mode 0,0 by hand, as Microchip's DS21295 and DS21298 draw it in section 5.
struct Mcp3208Wiring {
    // Offsets on the GPIO chip, named as the converter names its pins: DIN is our output.
    unsigned clk = 0;
    unsigned din = 0;
    unsigned dout = 0;
    unsigned cs = 0;
};

// The converter's pins in GpioLines' values, by the order of mcp3208_lines.
constexpr std::uint32_t kMcp3208Clk = 1;
constexpr std::uint32_t kMcp3208Din = 2;
constexpr std::uint32_t kMcp3208Dout = 4;
constexpr std::uint32_t kMcp3208Cs = 8;

// The lines in the order in which convert_mcp3208 wants them, CS high and the clock low.
std::array<GpioLine, 4> mcp3208_lines(Mcp3208Wiring const& wiring);

struct Mcp3208Channel {
    unsigned bits = 12;   // 10 for an MCP3008.
    unsigned channel = 0; // 0 to 7, against ground.
};

// One conversion.
struct Mcp3208Reading {
    std::int32_t counts = 0;
    // False if DOUT was high where the converter sends a zero: nobody drives the line.
    bool is_answered = false;
    Timestamp sampled {}; // When the converter stopped sampling.
    Duration held {};     // Time from then, at the earliest, to the last bit, at the latest.
};

// The hold capacitor leaks: a conversion must be over this long after sampling (DS21298, section
// 6.2). One that the scheduler interrupted for longer reads too low and has to be repeated.
constexpr Duration kMcp3208HoldLimit = std::chrono::microseconds(1200);

// Converts once, in 51 requests to the kernel. `now` is a monotonic clock. Fails when the lines do.
Result<Mcp3208Reading> convert_mcp3208(GpioLines& lines, Mcp3208Channel const& channel,
                                       std::function<Timestamp()> const& now);

} // namespace tractus::drivers
