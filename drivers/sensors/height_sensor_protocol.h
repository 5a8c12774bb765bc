#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tractus::drivers {

// Constants of the protocol of the station's own height sensor, which
// firmware-notes/height-sensor-protocol.md specifies byte by byte. Numbers are little-endian.

// Class of the sensor's interface, which identifies the sensor regardless of its ids.
constexpr std::uint8_t kHeightSensorClass = 0xFF;
constexpr std::uint8_t kHeightSensorSubclass = 0x54;
constexpr std::uint8_t kHeightSensorProtocol = 0x01;

// The interface's string is this title and the greatest reading as a decimal number.
constexpr std::string_view kHeightSensorTitle = "tractus height sensor 1, full scale ";

// Control requests to the interface; bmRequestType is 0xC1 for Get requests and 0x41 for Set
// requests.
enum class HeightSensorRequest : std::uint8_t {
    GetIdentity = 0x01,
    GetRate = 0x02,
    SetRate = 0x03,
    GetReference = 0x04,
    SetReference = 0x05,
    SetStreaming = 0x06,
};
constexpr std::uint8_t kVendorInterfaceIn = 0xC1;
constexpr std::uint8_t kVendorInterfaceOut = 0x41;

constexpr std::size_t kHeightIdentityBytes = 20;
constexpr std::size_t kHeightRateBytes = 4;

// Voltage across the potentiometer, to which full scale corresponds.
enum class HeightReference : std::uint8_t {
    Supply = 0,   // The converter's supply: the measurement is ratiometric, so drift cancels.
    Internal = 1, // The converter's internal reference.
};

// A frame is a header, readings of two bytes each, and a CRC. It is always sent as one packet of
// the bulk endpoint, and is shorter than the maximum packet, even at full speed.
constexpr std::array<std::uint8_t, 4> kHeightFrameMagic { 'T', 'R', 'H', 1 };
constexpr std::size_t kHeightFrameHeaderBytes = 14;
constexpr std::size_t kHeightFrameCrcBytes = 2;
constexpr std::size_t kMaxHeightFrameSamples = 23;
constexpr std::size_t kMaxHeightFrameBytes
    = kHeightFrameHeaderBytes + 2 * kMaxHeightFrameSamples + kHeightFrameCrcBytes;

// Bits of HeightFrame::flags. Other bits are reserved: sent as 0 and ignored.
constexpr std::uint8_t kHeightFrameStart = 0x01;   // First frame since streaming was switched on.
constexpr std::uint8_t kHeightFrameOverrun = 0x02; // Readings before this frame were lost.
constexpr std::uint8_t kHeightFrameReferenceFault = 0x04; // Supply or reference is out of range.

// A frame's contents.
struct HeightFrame {
    std::uint8_t flags = 0;
    std::uint16_t sequence = 0;  // Increases by one with each frame, including lost ones; wraps.
    std::uint32_t device_us = 0; // The sensor's clock at the first reading; wraps.
    std::uint16_t period_us = 0; // Time between readings in microseconds.
    std::size_t count = 0;       // Number of readings, 1 to kMaxHeightFrameSamples.
    std::array<std::uint16_t, kMaxHeightFrameSamples> counts {};

    std::span<std::uint16_t const> readings() const { return std::span(counts).first(count); }
};

// Returns the CRC-16 of a frame up to its CRC field: polynomial x^16 + x^12 + x^5 + 1 (0x1021),
// initial value 0xFFFF, most significant bit first, no final XOR ("CRC-16/IBM-3740", often called
// CCITT-FALSE). The check value, for the text "123456789", is 0x29B1.
std::uint16_t height_frame_crc(std::span<std::byte const> bytes);

} // namespace tractus::drivers
