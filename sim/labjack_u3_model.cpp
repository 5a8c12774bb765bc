#include "sim/labjack_u3_model.h"

#include "drivers/sensors/labjack_packet.h"
#include "engine/base/check.h"

#include <algorithm>
#include <cmath>

namespace tractus::sim {

namespace {

constexpr std::uint8_t kAnalogInput = 1; // IOType of an analogue input in the Feedback command.
constexpr std::uint8_t kInvalidPin = 96;
constexpr std::uint8_t kPinIsDigital = 98;
constexpr std::uint8_t kIoTypeNotValid = 101;
constexpr std::uint16_t kHighVoltageInputs = 0x000F;

using Bytes = std::vector<std::byte>;

void put_u16(Bytes& bytes, std::size_t at, std::uint32_t value)
{
    bytes[at] = static_cast<std::byte>(value & 0xFF);
    bytes[at + 1] = static_cast<std::byte>(value >> 8 & 0xFF);
}

// Writes a signed fixed-point number with 32 bits before the point and 32 after it.
void put_fixed(Bytes& bytes, std::size_t at, double value)
{
    auto const fixed = static_cast<std::uint64_t>(std::llround(value * 4294967296.0));
    for (std::size_t i = 0; i < 8; ++i)
        bytes[at + i] = static_cast<std::byte>(fixed >> 8 * i & 0xFF);
}

} // namespace

LabJackU3Model::LabJackU3Model()
    : LabJackU3Model(Options {})
{
}

LabJackU3Model::LabJackU3Model(Options const& options)
    : options_(options)
    , analog_(options.is_high_voltage ? kHighVoltageInputs : std::uint16_t { 0 })
{
}

void LabJackU3Model::set_counts(int channel, std::uint16_t counts)
{
    CHECK(channel >= 0 && channel < 16);
    counts_[static_cast<std::size_t>(channel)] = counts & 0xFFF0;
}

std::vector<std::byte> LabJackU3Model::answer(std::span<std::byte const> command)
{
    if (drivers::check_labjack_packet(command) != drivers::LabJackDefect::None)
        return { std::byte { 0xB8 }, std::byte { 0xB8 } };
    auto const data = command.subspan(drivers::kLabJackHeaderBytes);
    auto const name = static_cast<drivers::LabJackCommand>(command[3]);
    switch (name) {
    case drivers::LabJackCommand::Feedback:
        return drivers::labjack_packet(name, answer_feedback(data));
    case drivers::LabJackCommand::ConfigIo:
        return drivers::labjack_packet(name, answer_config_io(data));
    case drivers::LabJackCommand::ConfigU3:
        return drivers::labjack_packet(name, answer_config_u3());
    case drivers::LabJackCommand::ReadMemory:
        return drivers::labjack_packet(name, answer_read_memory(data));
    }
    return { std::byte { 0xB8 }, std::byte { 0xB8 } };
}

// Returns the reply to a Feedback command: error code, position of the error, echo, reading.
std::vector<std::byte> LabJackU3Model::answer_feedback(std::span<std::byte const> data) const
{
    Bytes reply(6);
    if (data.size() < 4)
        return reply;
    reply[2] = data[0];
    auto const channel = std::to_integer<std::size_t>(data[2]) & 0x1F;
    std::uint8_t error = 0;
    if (std::to_integer<std::uint8_t>(data[1]) != kAnalogInput)
        error = kIoTypeNotValid;
    else if (channel >= counts_.size())
        error = kInvalidPin;
    else if ((analog_ >> channel & 1) == 0)
        error = kPinIsDigital;
    else
        put_u16(reply, 3, counts_[channel]);
    reply[0] = std::byte { error };
    reply[1] = std::byte { error != 0 };
    return reply;
}

std::vector<std::byte> LabJackU3Model::answer_config_io(std::span<std::byte const> data)
{
    Bytes reply(6);
    if (data.size() < 6)
        return reply;
    auto const mask = std::to_integer<unsigned>(data[0]);
    if (mask & 4)
        analog_
            = static_cast<std::uint16_t>((analog_ & 0xFF00) | std::to_integer<unsigned>(data[4]));
    if (mask & 8)
        analog_ = static_cast<std::uint16_t>((analog_ & 0x00FF)
                                             | std::to_integer<unsigned>(data[5]) << 8);
    if (options_.is_high_voltage)
        analog_ |= kHighVoltageInputs;
    put_u16(reply, 4, analog_);
    return reply;
}

std::vector<std::byte> LabJackU3Model::answer_config_u3() const
{
    Bytes reply(32);
    put_u16(reply, 3, 0x012E); // Version 1.46 of the firmware.
    put_u16(reply, 7, 0x011E); // Version 1.30 of the hardware.
    put_u16(reply, 9, options_.serial_number & 0xFFFF);
    put_u16(reply, 11, options_.serial_number >> 16);
    put_u16(reply, 13, 3);
    put_u16(reply, 17, analog_ & 0xFF);
    reply[31] = options_.is_high_voltage ? std::byte { 18 } : std::byte { 2 };
    return reply;
}

// Returns calibration blocks: block 0 has the low-voltage inputs, blocks 3 and 4 have the slopes
// and offsets of the high-voltage inputs.
std::vector<std::byte> LabJackU3Model::answer_read_memory(std::span<std::byte const> data) const
{
    Bytes reply(34);
    if (data.size() < 2)
        return reply;
    auto const block = std::to_integer<unsigned>(data[1]);
    if (block == 0) {
        put_fixed(reply, 2, options_.volts_per_count);
        put_fixed(reply, 10, options_.offset_volts);
    }
    for (std::size_t i = 0; i < 4 && (block == 3 || block == 4); ++i)
        put_fixed(reply, 2 + 8 * i,
                  block == 3 ? options_.high_volts_per_count : options_.high_offset_volts);
    return reply;
}

} // namespace tractus::sim
