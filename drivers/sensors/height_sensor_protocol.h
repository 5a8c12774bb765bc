#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tractus::drivers {

// The numbers of the station's own height sensor. firmware-notes/height-sensor-protocol.md is the
// protocol itself, to the byte; numbers of several bytes have their lowest byte first.

// The sensor's interface, which tells it from every other device whatever its ids are.
constexpr std::uint8_t kHeightSensorClass = 0xFF;
constexpr std::uint8_t kHeightSensorSubclass = 0x54;
constexpr std::uint8_t kHeightSensorProtocol = 0x01;

// The string of that interface is this and the greatest reading as a decimal number.
constexpr std::string_view kHeightSensorTitle = "tractus height sensor 1, full scale ";

// Requests to the interface: bmRequestType 0xC1 for those that get, 0x41 for those that set.
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

// Supply of the potentiometer's ends, which is what full scale means.
enum class HeightReference : std::uint8_t {
    Supply = 0,   // The converter's supply: ratiometric, its drift cancels.
    Internal = 1, // The converter's own reference.
};

// A frame: a header, the readings with two bytes each, and the CRC. It is always one packet of the
// bulk endpoint, also at full speed, and never fills it.
constexpr std::array<std::uint8_t, 4> kHeightFrameMagic { 'T', 'R', 'H', 1 };
constexpr std::size_t kHeightFrameHeaderBytes = 14;
constexpr std::size_t kHeightFrameCrcBytes = 2;
constexpr std::size_t kMaxHeightFrameSamples = 23;
constexpr std::size_t kMaxHeightFrameBytes
    = kHeightFrameHeaderBytes + 2 * kMaxHeightFrameSamples + kHeightFrameCrcBytes;

// Bits of HeightFrame::flags. Others are reserved: sent as 0, not looked at.
constexpr std::uint8_t kHeightFrameStart = 0x01;   // First one since streaming was switched on.
constexpr std::uint8_t kHeightFrameOverrun = 0x02; // Readings before this frame were lost.
constexpr std::uint8_t kHeightFrameReferenceFault = 0x04; // Supply or reference out of its range.

// A frame's contents.
struct HeightFrame {
    std::uint8_t flags = 0;
    std::uint16_t sequence = 0;  // One more per frame, lost ones too; wraps.
    std::uint32_t device_us = 0; // The sensor's clock at the first reading; wraps.
    std::uint16_t period_us = 0; // Time between readings.
    std::size_t count = 0;       // 1 to kMaxHeightFrameSamples.
    std::array<std::uint16_t, kMaxHeightFrameSamples> counts {};

    std::span<std::uint16_t const> readings() const { return std::span(counts).first(count); }
};

// CRC-16 of a frame up to its CRC: polynomial x^16 + x^12 + x^5 + 1 (0x1021), initial value 0xFFFF,
// highest bit first, result as it is ("CRC-16/IBM-3740", often called CCITT-FALSE). Of the text
// "123456789" it is 0x29B1.
std::uint16_t height_frame_crc(std::span<std::byte const> bytes);

} // namespace tractus::drivers
