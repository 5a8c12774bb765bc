#include "drivers/sensors/height_sensor_protocol.h"

namespace tractus::drivers {

namespace {

constexpr std::uint16_t kPolynomial = 0x1021;
constexpr std::size_t kSlices = 4;

using CrcTables = std::array<std::array<std::uint16_t, 256>, kSlices>;

// Table k has the CRC of each byte followed by k zero bytes, so that four bytes take four
// independent look-ups.
constexpr CrcTables make_tables()
{
    CrcTables tables {};
    for (unsigned byte = 0; byte < 256; ++byte) {
        unsigned crc = byte << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1) ^ ((crc & 0x8000) ? kPolynomial : 0u);
        tables[0][byte] = static_cast<std::uint16_t>(crc);
    }
    for (std::size_t k = 1; k < kSlices; ++k)
        for (std::size_t byte = 0; byte < 256; ++byte) {
            unsigned const before = tables[k - 1][byte];
            tables[k][byte] = static_cast<std::uint16_t>((before << 8) ^ tables[0][before >> 8]);
        }
    return tables;
}

constexpr CrcTables kTables = make_tables();

} // namespace

std::uint16_t height_frame_crc(std::span<std::byte const> bytes)
{
    unsigned crc = 0xFFFF;
    std::size_t i = 0;
    auto const at = [&](std::size_t k) { return std::to_integer<unsigned>(bytes[k]); };
    for (; i + kSlices <= bytes.size(); i += kSlices)
        crc = kTables[3][(crc >> 8) ^ at(i)] ^ kTables[2][(crc & 0xFF) ^ at(i + 1)]
            ^ kTables[1][at(i + 2)] ^ kTables[0][at(i + 3)];
    for (; i < bytes.size(); ++i)
        crc = (crc << 8 & 0xFFFF) ^ kTables[0][(crc >> 8) ^ at(i)];
    return static_cast<std::uint16_t>(crc);
}

} // namespace tractus::drivers
