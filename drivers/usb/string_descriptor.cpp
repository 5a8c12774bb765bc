#include "drivers/usb/string_descriptor.h"

#include <algorithm>
#include <cstdint>

namespace tractus::drivers {

namespace {

void append_utf8(std::string& text, std::uint32_t point)
{
    auto const put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    auto const put_tail = [&](unsigned shift) { put(0x80 | (point >> shift & 0x3F)); };
    if (point < 0x80) {
        put(point);
    } else if (point < 0x800) {
        put(0xC0 | point >> 6);
        put_tail(0);
    } else if (point < 0x1'0000) {
        put(0xE0 | point >> 12);
        put_tail(6);
        put_tail(0);
    } else {
        put(0xF0 | point >> 18);
        put_tail(12);
        put_tail(6);
        put_tail(0);
    }
}

// Removes the next code point from the text and returns it. Bytes that are not valid UTF-8 count as
// one code point each.
std::uint32_t take_point(std::string_view& text)
{
    auto const byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    std::uint32_t const first = byte(0);
    std::size_t const size = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    std::uint32_t point = first;
    if (size > 1 && size <= text.size()) {
        point = first & (0x7Fu >> size);
        for (std::size_t i = 1; i < size; ++i)
            point = point << 6 | (byte(i) & 0x3F);
    }
    text.remove_prefix(std::min(size, text.size()));
    return point;
}

bool is_high_half(std::uint32_t unit)
{
    return unit >= 0xD800 && unit < 0xDC00;
}
bool is_low_half(std::uint32_t unit)
{
    return unit >= 0xDC00 && unit < 0xE000;
}

} // namespace

std::string string_descriptor_text(std::span<std::byte const> bytes)
{
    std::vector<std::uint32_t> units;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        units.push_back(std::to_integer<std::uint32_t>(bytes[i])
                        | std::to_integer<std::uint32_t>(bytes[i + 1]) << 8);
    std::string text;
    for (std::size_t i = 0; i < units.size(); ++i) {
        auto point = units[i];
        if (is_high_half(point) && i + 1 < units.size() && is_low_half(units[i + 1]))
            point = 0x1'0000 + ((point - 0xD800) << 10 | (units[++i] - 0xDC00));
        append_utf8(text, point);
    }
    return text;
}

std::vector<std::byte> string_descriptor_bytes(std::string_view text)
{
    std::vector<std::byte> bytes;
    auto const put = [&](std::uint32_t unit) {
        bytes.push_back(static_cast<std::byte>(unit & 0xFF));
        bytes.push_back(static_cast<std::byte>(unit >> 8 & 0xFF));
    };
    while (!text.empty()) {
        auto const point = take_point(text);
        if (point >= 0x1'0000) {
            put(0xD800 + ((point - 0x1'0000) >> 10));
            put(0xDC00 + ((point - 0x1'0000) & 0x3FF));
        } else {
            put(point);
        }
    }
    return bytes;
}

} // namespace tractus::drivers
