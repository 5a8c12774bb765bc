#include "engine/base/printable.h"

#include <algorithm>
#include <cstddef>
#include <fmt/core.h>

namespace tractus {

std::string_view first_character(std::string_view text)
{
    auto const lead = static_cast<unsigned char>(text.front());
    std::size_t const size = lead >= 0xf0 && lead < 0xf5 ? 4
        : lead >= 0xe0 && lead < 0xf0                    ? 3
        : lead >= 0xc2 && lead < 0xe0                    ? 2
                                                         : 1;
    if (size > text.size())
        return text.substr(0, 1);
    auto const rest = text.substr(1, size - 1);
    bool const is_whole
        = std::all_of(rest.begin(), rest.end(), [](char c) { return (c & 0xc0) == 0x80; });
    return text.substr(0, is_whole ? size : 1);
}

// True if the character is one of the 65 Unicode control characters or is not valid UTF-8.
static bool is_control(std::string_view character)
{
    auto const lead = static_cast<unsigned char>(character.front());
    if (character.size() == 1)
        return lead < 0x20 || lead >= 0x7f;
    return lead == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0;
}

std::string printable(std::string_view text, std::string_view kept)
{
    std::string result;
    while (!text.empty()) {
        auto const character = first_character(text);
        text.remove_prefix(character.size());
        auto const code = character.front();
        if (!is_control(character) || kept.find(code) != std::string_view::npos)
            result += character;
        else if (code == '\n' || code == '\t' || code == '\r')
            result += code == '\n' ? "\\n" : code == '\t' ? "\\t" : "\\r";
        else
            for (char const byte : character)
                result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    }
    return result;
}

} // namespace tractus
