#pragma once

#include "engine/base/time.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace tractus::sim {

// The converters MCP3008 (10 bits) and MCP3208 (12 bits) as seen at their pins (Microchip DS21295
// and DS21298, sections 5 and 6). The model's input is every change of a pin with its time; its
// output is DOUT. Code that bit-bangs the real chip can therefore use this model at any speed.
//
// A conversion, in edges of CLK while CS is low:
//
//   rising 1         start: the first rising edge at which DIN is high
//   rising 2         single-ended (1) or the difference of a pair of inputs (0)
//   rising 3, 4, 5   the channel, D2 D1 D0; at the last of them it begins to sample
//   falling 6        it stops sampling, and DOUT leaves high impedance for the null bit, 0
//   falling 7 …      the reading, highest bit first
//   …                the same bits again from the second lowest up, then zeros
//
// CS high ends the conversion at any point and leaves DOUT at high impedance. The hold capacitor
// leaks from falling edge 6 on, and each bit is decided at its falling edge: too slow a clock
// (below about 10 kHz; the data sheets allow 1.2 ms) makes the reading droop. No clock and no
// randomness are used.
class Mcp3208Model {
public:
    // Returns a channel's voltage as a fraction of the reference, clamped to 0 to 1. Sensor faults
    // (an open wiper, noise) are simulated here.
    using Inputs = std::function<double(unsigned channel, Timestamp time)>;

    struct Options {
        unsigned bits = 12; // Resolution; 10 for an MCP3008.
        // Droop of the hold capacitor: one 12-bit count per millisecond.
        double droop_per_second = 0.25;
    };

    Mcp3208Model(Inputs inputs, Options options);

    struct Pins {
        bool clk = false;
        bool din = false;
        bool cs = true; // True if CS is high: the chip is not selected.

        bool operator==(Pins const&) const = default;
    };

    // Sets the pins from `time` on. Times must not go back. If several pins change at once, an edge
    // of CLK reads the previous DIN, as with a master in SPI mode 0.
    void set_pins(Timestamp time, Pins const& pins);

    // Returns the level of DOUT. No value: high impedance, so the level depends on what pulls the
    // wire.
    std::optional<bool> dout() const;

    // Wires that can be broken. A broken CLK or DIN reads low; a broken CS reads high, thanks to
    // the pull-up in firmware-notes/wiring.md; a broken DOUT is high impedance.
    enum class Wire { Clk, Din, Dout, Cs };
    void break_wire(Wire wire);
    void mend_wire(Wire wire);

    // Number of conversions that reached their last bit.
    std::uint64_t conversions() const { return conversions_; }

private:
    void rise(bool din);
    void fall();
    double held_at(Timestamp time) const;
    void decide_next_bit();

    bool is_broken(Wire wire) const { return broken_ >> static_cast<unsigned>(wire) & 1; }

    Inputs inputs_;
    Options options_;
    unsigned broken_ = 0; // Broken wires, one bit each.
    Pins pins_ {};        // Levels as the chip sees them.
    Timestamp now_ {};

    unsigned clock_ = 0;   // Rising edges since the start bit, including it; 0 before it.
    unsigned command_ = 0; // The four bits after the start bit.
    double held_ = 0;      // Voltage of the hold capacitor when sampling ended.
    Timestamp held_since_ {};
    std::uint32_t code_ = 0; // Bits decided so far, in their positions.
    std::optional<bool> dout_ {};
    std::uint64_t conversions_ = 0;
};

} // namespace tractus::sim
