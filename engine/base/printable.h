#pragma once

#include <string>
#include <string_view>

namespace tractus {

// The UTF-8 character that the text begins with; one byte where there is none. Not for empty text.
std::string_view first_character(std::string_view text);

// The text as a terminal may show it: control characters, which could change what it shows, and
// bytes that are no UTF-8 become escapes, such as \x1b. Those in `kept` stay as they are.
std::string printable(std::string_view text, std::string_view kept = {});

} // namespace tractus
