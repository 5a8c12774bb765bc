#pragma once

#include "engine/base/time.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace tractus::sim {

// The MCP3008 (10 bits) and MCP3208 (12 bits) as seen at their pins: Microchip DS21295 and DS21298,
// sections 5 and 6. Pins go in as they change, each with its time, and DOUT comes out; so whatever
// bit-bangs the real chip can talk to this one, and does so at its own pace.
//
// A conversion, in edges of CLK while CS is low:
//
//   rising 1         start: the first rising edge at which DIN is high
//   rising 2         single-ended (1) or the difference of a pair of inputs (0)
//   rising 3, 4, 5   the channel, D2 D1 D0; at the last of them it begins to sample
//   falling 6        it stops sampling, and DOUT leaves high impedance for the null bit, 0
//   falling 7 …      the reading, highest bit first
//   … and then the same bits again from the second lowest up, then zeros
//
// CS high ends it at any point and leaves DOUT open. The hold capacitor leaks from falling edge 6
// on, and each bit is decided when its falling edge comes: too slow a clock (below some 10 kHz, by
// the data sheets 1.2 ms) makes the reading droop. No clock, no randomness.
class Mcp3208Model {
public:
    // A channel's voltage as a fraction of the reference: 0 to 1, clamped. What is wrong with the
    // sensor (an open wiper, noise) is said here.
    using Inputs = std::function<double(unsigned channel, Timestamp time)>;

    struct Options {
        unsigned bits = 12; // 10 for an MCP3008.
        // Droop of the reference: a count of 12 bits in a millisecond.
        double droop_per_second = 0.25;
    };

    Mcp3208Model(Inputs inputs, Options options);

    struct Pins {
        bool clk = false;
        bool din = false;
        bool cs = true; // High: not selected.

        bool operator==(Pins const&) const = default;
    };

    // The pins are so from `time` on. Times must not go backwards. When several pins change at
    // once, DIN is what it was before for an edge of CLK, as with a master of SPI mode 0.
    void set_pins(Timestamp time, Pins const& pins);

    // Level of DOUT. No value: high impedance, and whatever pulls the wire decides.
    std::optional<bool> dout() const;

    // A wire that is broken. A broken CLK or DIN is taken to read low; a broken CS reads high,
    // which is what the pull-up in firmware-notes/wiring.md is for; a broken DOUT is high
    // impedance.
    enum class Wire { Clk, Din, Dout, Cs };
    void break_wire(Wire wire);
    void mend_wire(Wire wire);

    // How many conversions came to their last bit.
    std::uint64_t conversions() const { return conversions_; }

private:
    void rise(bool din);
    void fall();
    double held_at(Timestamp time) const;
    void decide_next_bit();

    bool is_broken(Wire wire) const { return broken_ >> static_cast<unsigned>(wire) & 1; }

    Inputs inputs_;
    Options options_;
    unsigned broken_ = 0; // One bit per wire.
    Pins pins_ {};        // Pins as the chip sees them.
    Timestamp now_ {};

    unsigned clock_ = 0;   // Rising edges since the start bit, with it; 0 before.
    unsigned command_ = 0; // The four bits after it.
    double held_ = 0;      // Voltage on the capacitor when sampling stopped.
    Timestamp held_since_ {};
    std::uint32_t code_ = 0; // The bits decided so far, in their places.
    std::optional<bool> dout_ {};
    std::uint64_t conversions_ = 0;
};

} // namespace tractus::sim
