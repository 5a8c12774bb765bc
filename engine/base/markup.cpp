#include "engine/base/markup.h"

namespace tractus {

std::string escape_markup(std::string_view text)
{
    std::string escaped;
    for (char const letter : text)
        switch (letter) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += letter;
        }
    return escaped;
}

} // namespace tractus
