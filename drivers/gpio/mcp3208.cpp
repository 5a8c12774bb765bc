#include "drivers/gpio/mcp3208.h"

namespace tractus::drivers {

namespace {

// The command consists of a start bit, a single-ended bit and three channel bits.
constexpr unsigned kCommand = 0b11'000;
constexpr unsigned kCommandBits = 5;

// One clock cycle with CS low. The converter samples `din` at the rising edge and changes DOUT at
// the falling edge. DIN stays stable in between; it changes while the clock is low, in the next
// call.
Result<void> rise(GpioLines& lines, std::uint32_t din)
{
    return lines.set(kMcp3208Clk | din);
}

Result<void> fall(GpioLines& lines, std::uint32_t next_din)
{
    return lines.set(next_din);
}

std::uint32_t command_bit(unsigned channel, unsigned index)
{
    unsigned const command = kCommand | channel;
    if (index >= kCommandBits)
        return 0;
    return command >> (kCommandBits - 1 - index) & 1 ? kMcp3208Din : 0;
}

Result<bool> read_dout(GpioLines& lines)
{
    return (TRY(lines.get()) & kMcp3208Dout) != 0;
}

} // namespace

std::array<GpioLine, 4> mcp3208_lines(Mcp3208Wiring const& wiring)
{
    using enum GpioLine::Direction;
    return { GpioLine { wiring.clk, Output, false }, GpioLine { wiring.din, Output, false },
             GpioLine { wiring.dout, Input, false }, GpioLine { wiring.cs, Output, true } };
}

Result<Mcp3208Reading> convert_mcp3208(GpioLines& lines, Mcp3208Channel const& channel,
                                       std::function<Timestamp()> const& now)
{
    TRY(lines.set(command_bit(channel.channel, 0))); // CS goes low with the start bit on DIN.
    for (unsigned i = 0; i < kCommandBits; ++i) {
        TRY(rise(lines, command_bit(channel.channel, i)));
        TRY(fall(lines, command_bit(channel.channel, i + 1)));
    }

    // Sampling ends between these two clock readings.
    Mcp3208Reading reading;
    TRY(rise(lines, 0));
    auto const before = now();
    TRY(fall(lines, 0));
    reading.sampled = now();
    reading.is_answered = !TRY(read_dout(lines));
    for (unsigned i = 0; i < channel.bits; ++i) {
        TRY(rise(lines, 0));
        TRY(fall(lines, 0));
        reading.counts = reading.counts << 1 | static_cast<std::int32_t>(TRY(read_dout(lines)));
    }
    reading.held = now() - before;
    TRY(lines.set(kMcp3208Cs));
    return reading;
}

} // namespace tractus::drivers
