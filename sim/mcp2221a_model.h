#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::sim {

// A Microchip MCP2221A as its HID interface shows it: 64 bytes of command in, 64 bytes of reply out
// (datasheet DS20005565, section 3.1). It knows the commands that have to do with its pins and its
// converter, 0x10 status, 0x51 pins as GPIO, 0x60 and 0x61 settings, and answers every
// other one as a command that it does not support.
class Mcp2221aModel {
public:
    static constexpr std::size_t kPacketBytes = 64;
    using Packet = std::array<std::byte, kPacketBytes>;

    struct Options {
        double supply_volts = 5;
        // Functions of GP0 to GP3 after power-up, as bytes 8 to 11 of command 0x60 have them; 8 is
        // a digital input.
        std::array<std::uint8_t, 4> pins { 8, 8, 8, 8 };
    };

    Mcp2221aModel();
    explicit Mcp2221aModel(Options const& options);

    // Puts so many volts at GP`pin`, 1 to 3, from now on.
    void set_volts(int pin, double volts);

    // The reply to one command, of which bytes beyond 64 are left out and missing ones are 0.
    Packet answer(std::span<std::byte const> command);

    // Whether some pin is the converter's.
    bool converts() const;

    // Returns what GP`pin`, 1 to 3, converts to now: 0 to 1023.
    std::uint16_t counts(int pin) const;

private:
    Packet answer_status() const;
    Packet answer_settings() const;
    void change_settings(std::span<std::byte const, kPacketBytes> command);

    double supply_volts_;
    std::array<double, 4> volts_ {};
    std::array<std::uint8_t, 4> pins_;
    // Bits 2 and 1: which voltage; bit 0: it and not the supply.
    std::uint8_t reference_ = 0;
    std::uint8_t told_reference_ = 0; // Reference that the settings claim.
};

} // namespace tractus::sim
