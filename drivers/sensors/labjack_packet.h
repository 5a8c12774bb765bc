#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::drivers {

// The U3's extended packets (U3 user's guide, section 5.2) consist of a checksum of the header,
// 0xF8, the number of 16-bit data words, the command, a checksum of the data, and the data.
constexpr std::size_t kLabJackHeaderBytes = 6;

enum class LabJackCommand : std::uint8_t {
    Feedback = 0x00,
    ConfigU3 = 0x08,
    ConfigIo = 0x0B,
    ReadMemory = 0x2D,
};

// Builds a packet with both checksums. `data` is padded to whole words.
std::vector<std::byte> labjack_packet(LabJackCommand command, std::span<std::byte const> data);

// Reasons why a packet is invalid.
enum class LabJackDefect {
    None,
    TooShort, // Shorter than a header, or than its header says.
    NotExtended,
    HeaderChecksum,
    DataChecksum,
};
LabJackDefect check_labjack_packet(std::span<std::byte const> packet);

} // namespace tractus::drivers
