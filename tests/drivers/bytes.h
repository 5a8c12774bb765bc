#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Parses bytes written as "05 0d 09 02".
inline std::vector<std::byte> bytes(std::string_view text)
{
    std::vector<std::byte> result;
    for (std::size_t i = 0; i + 1 < text.size();) {
        if (text[i] == ' ' || text[i] == '\n') {
            ++i;
            continue;
        }
        std::uint8_t value = 0;
        std::from_chars(text.data() + i, text.data() + i + 2, value, 16);
        result.push_back(std::byte { value });
        i += 2;
    }
    return result;
}

} // namespace tractus::drivers
