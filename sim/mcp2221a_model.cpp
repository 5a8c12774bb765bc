#include "sim/mcp2221a_model.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::sim {

namespace {

// Commands (MCP2221A datasheet, table 3-1): the first byte, which the reply repeats.
constexpr std::byte kStatus { 0x10 };
constexpr std::byte kGetGpio { 0x51 };
constexpr std::byte kSetSettings { 0x60 };
constexpr std::byte kGetSettings { 0x61 };

constexpr std::byte kNotSupported { 0x01 };
constexpr std::byte kChange { 0x80 };
// Pin function of GP1 to GP3: input of the converter.
constexpr std::uint8_t kConverterFunction = 2;

void put_u16(Mcp2221aModel::Packet& packet, std::size_t at, unsigned value)
{
    packet[at] = static_cast<std::byte>(value & 0xFF);
    packet[at + 1] = static_cast<std::byte>(value >> 8);
}

} // namespace

Mcp2221aModel::Mcp2221aModel()
    : Mcp2221aModel(Options {})
{
}

Mcp2221aModel::Mcp2221aModel(Options const& options)
    : supply_volts_(options.supply_volts)
    , pins_(options.pins)
{
}

void Mcp2221aModel::set_volts(int pin, double volts)
{
    CHECK(pin >= 1 && pin <= 3);
    volts_[static_cast<std::size_t>(pin)] = volts;
}

Mcp2221aModel::Packet Mcp2221aModel::answer(std::span<std::byte const> command)
{
    Packet full {};
    std::copy_n(command.begin(), std::min(command.size(), full.size()), full.begin());
    Packet reply {};
    if (full[0] == kStatus)
        reply = answer_status();
    else if (full[0] == kGetSettings)
        reply = answer_settings();
    else if (full[0] == kSetSettings)
        change_settings(full);
    else if (full[0] == kGetGpio)
        for (std::size_t pin = 0; pin < pins_.size(); ++pin) {
            bool const is_gpio = (pins_[pin] & 7) == 0;
            reply[2 + 2 * pin] = is_gpio ? std::byte(pins_[pin] >> 4 & 1) : std::byte { 0xEE };
            reply[3 + 2 * pin] = is_gpio ? std::byte(pins_[pin] >> 3 & 1) : std::byte { 0xEF };
        }
    else
        reply[1] = kNotSupported;
    reply[0] = full[0];
    return reply;
}

Mcp2221aModel::Packet Mcp2221aModel::answer_status() const
{
    Packet reply {};
    reply[46] = std::byte { 'A' }; // Revisions of hardware and firmware.
    reply[47] = std::byte { '6' };
    reply[48] = std::byte { '1' };
    reply[49] = std::byte { '2' };
    for (int pin = 1; pin <= 3; ++pin)
        put_u16(reply, 48 + 2 * static_cast<std::size_t>(pin), counts(pin));
    return reply;
}

Mcp2221aModel::Packet Mcp2221aModel::answer_settings() const
{
    Packet reply {};
    // Byte 2 is the length of the settings in bytes, byte 3 that of the password.
    reply[2] = std::byte { 18 };
    reply[3] = std::byte { 4 };
    // Bits 4 and 3 select the internal voltage; bit 2 selects it instead of the supply.
    reply[7] = static_cast<std::byte>((configured_reference_ & 6) << 2
                                      | (configured_reference_ & 1) << 2);
    put_u16(reply, 8, 0x04D8);
    put_u16(reply, 10, 0x00DD);
    reply[12] = std::byte { 0x80 };
    reply[13] = std::byte { 50 };
    for (std::size_t pin = 0; pin < pins_.size(); ++pin)
        reply[22 + pin] = static_cast<std::byte>(pins_[pin]);
    return reply;
}

void Mcp2221aModel::change_settings(std::span<std::byte const, kPacketBytes> command)
{
    auto const at = [&](std::size_t i) { return std::to_integer<std::uint8_t>(command[i]); };
    bool const changes_pins = (command[7] & kChange) != std::byte {};
    bool const changes_reference = (command[5] & kChange) != std::byte {};
    if (changes_pins) {
        for (std::size_t pin = 0; pin < pins_.size(); ++pin)
            pins_[pin] = at(8 + pin) & 0x1F;
        // The reference is reset to the supply, although the settings still show the old one
        // (MCP2221A datasheet, section 1.8.1.1).
        reference_ = 0;
    }
    if (changes_reference)
        reference_ = configured_reference_ = at(5) & 7;
}

bool Mcp2221aModel::converts() const
{
    return std::any_of(pins_.begin() + 1, pins_.end(),
                       [](std::uint8_t pin) { return (pin & 7) == kConverterFunction; });
}

std::uint16_t Mcp2221aModel::counts(int pin) const
{
    CHECK(pin >= 1 && pin <= 3);
    constexpr std::array<double, 4> kVolts { 0, 1.024, 2.048, 4.096 };
    auto const index = static_cast<std::size_t>(pin);
    if ((pins_[index] & 7) != kConverterFunction)
        return 0;
    double const full_volts
        = (reference_ & 1) != 0 ? kVolts[std::size_t { reference_ } >> 1 & 3] : supply_volts_;
    if (full_volts <= 0)
        return 1023;
    double const counts = std::floor(volts_[index] / full_volts * 1024);
    return static_cast<std::uint16_t>(std::clamp(counts, 0.0, 1023.0));
}

} // namespace tractus::sim
