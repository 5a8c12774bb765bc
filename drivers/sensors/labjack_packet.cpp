#include "drivers/sensors/labjack_packet.h"

#include <algorithm>

namespace tractus::drivers {

namespace {

constexpr std::byte kExtended { 0xF8 };

// Returns the sum of bytes 1 to 5 in eight bits, with the carry added back twice.
std::byte header_checksum(std::span<std::byte const> packet)
{
    unsigned sum = 0;
    for (auto const byte : packet.subspan(1, kLabJackHeaderBytes - 1))
        sum += std::to_integer<unsigned>(byte);
    sum = (sum >> 8) + (sum & 0xFF);
    sum = (sum >> 8) + (sum & 0xFF);
    return static_cast<std::byte>(sum & 0xFF);
}

std::uint16_t data_checksum(std::span<std::byte const> data)
{
    unsigned sum = 0;
    for (auto const byte : data)
        sum += std::to_integer<unsigned>(byte);
    return static_cast<std::uint16_t>(sum & 0xFFFF);
}

} // namespace

std::vector<std::byte> labjack_packet(LabJackCommand command, std::span<std::byte const> data)
{
    auto const words = (data.size() + 1) / 2;
    std::vector<std::byte> packet(kLabJackHeaderBytes + 2 * words);
    std::copy(data.begin(), data.end(), packet.begin() + kLabJackHeaderBytes);
    auto const sum = data_checksum(data);
    packet[1] = kExtended;
    packet[2] = static_cast<std::byte>(words);
    packet[3] = static_cast<std::byte>(command);
    packet[4] = static_cast<std::byte>(sum & 0xFF);
    packet[5] = static_cast<std::byte>(sum >> 8);
    packet[0] = header_checksum(packet);
    return packet;
}

LabJackDefect check_labjack_packet(std::span<std::byte const> packet)
{
    if (packet.size() < kLabJackHeaderBytes)
        return LabJackDefect::TooShort;
    if (packet[1] != kExtended)
        return LabJackDefect::NotExtended;
    if (packet[0] != header_checksum(packet))
        return LabJackDefect::HeaderChecksum;
    auto const data_bytes = 2 * std::to_integer<std::size_t>(packet[2]);
    if (packet.size() < kLabJackHeaderBytes + data_bytes)
        return LabJackDefect::TooShort;
    auto const sum = data_checksum(packet.subspan(kLabJackHeaderBytes, data_bytes));
    bool const is_sum = packet[4] == static_cast<std::byte>(sum & 0xFF)
        && packet[5] == static_cast<std::byte>(sum >> 8);
    return is_sum ? LabJackDefect::None : LabJackDefect::DataChecksum;
}

} // namespace tractus::drivers
