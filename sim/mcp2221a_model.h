#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::sim {

// A Microchip MCP2221A as seen through its HID interface: 64-byte commands, 64-byte replies
// (datasheet DS20005565, section 3.1). It supports the commands for its pins and its converter:
// 0x10 status, 0x51 pins as GPIO, 0x60 and 0x61 settings. It answers all others as unsupported.
class Mcp2221aModel {
public:
    static constexpr std::size_t kPacketBytes = 64;
    using Packet = std::array<std::byte, kPacketBytes>;

    struct Options {
        double supply_volts = 5;
        // Functions of GP0 to GP3 after power-up, encoded as in bytes 8 to 11 of command 0x60; 8 is
        // a digital input.
        std::array<std::uint8_t, 4> pins { 8, 8, 8, 8 };
    };

    Mcp2221aModel();
    explicit Mcp2221aModel(Options const& options);

    // Sets the voltage at GP`pin`, 1 to 3.
    void set_volts(int pin, double volts);

    // Returns the reply to a command. Bytes beyond 64 are ignored, and missing ones are 0.
    Packet answer(std::span<std::byte const> command);

    // True if any pin is an input of the converter.
    bool converts() const;

    // Returns the present reading of GP`pin`, 1 to 3, from 0 to 1023.
    std::uint16_t counts(int pin) const;

private:
    Packet answer_status() const;
    Packet answer_settings() const;
    void change_settings(std::span<std::byte const, kPacketBytes> command);

    double supply_volts_;
    std::array<double, 4> volts_ {};
    std::array<std::uint8_t, 4> pins_;
    // Encoded reference voltage: bits 2 and 1 select an internal voltage; bit 0 selects it instead
    // of the supply.
    std::uint8_t reference_ = 0;
    std::uint8_t configured_reference_ = 0; // Reference in the settings that the host reads.
};

} // namespace tractus::sim
