#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace tractus::drivers {

// Functions that read numbers from a report at a byte offset; the caller has checked the report's
// size. Numbers of pens are returned as int, so that they can be shifted and added.

inline int u8(std::span<std::byte const> report, std::size_t at)
{
    return std::to_integer<int>(report[at]);
}

inline int s8(std::span<std::byte const> report, std::size_t at)
{
    return static_cast<std::int8_t>(u8(report, at));
}

inline int u16_le(std::span<std::byte const> report, std::size_t at)
{
    return u8(report, at) | u8(report, at + 1) << 8;
}

inline int s16_le(std::span<std::byte const> report, std::size_t at)
{
    return static_cast<std::int16_t>(u16_le(report, at));
}

inline int u16_be(std::span<std::byte const> report, std::size_t at)
{
    return u8(report, at) << 8 | u8(report, at + 1);
}

inline int u24_le(std::span<std::byte const> report, std::size_t at)
{
    return u16_le(report, at) | u8(report, at + 2) << 16;
}

// Readers of unsigned little-endian numbers, which sensors' protocols use.
inline std::uint16_t u16(std::span<std::byte const> frame, std::size_t at)
{
    return static_cast<std::uint16_t>(u16_le(frame, at));
}

inline std::uint32_t u32(std::span<std::byte const> frame, std::size_t at)
{
    return u16(frame, at) | static_cast<std::uint32_t>(u16(frame, at + 2)) << 16;
}

// Returns `count` bits of one byte, beginning with bit `first`.
inline std::uint32_t bits(std::span<std::byte const> report, std::size_t at, unsigned first,
                          unsigned count)
{
    return (std::to_integer<std::uint32_t>(report[at]) >> first) & ((1u << count) - 1);
}

inline bool has_bit(std::span<std::byte const> report, std::size_t at, unsigned bit)
{
    return (u8(report, at) >> bit & 1) != 0;
}

} // namespace tractus::drivers
