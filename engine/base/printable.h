#pragma once

#include <string>
#include <string_view>

namespace tractus {

// Returns the first UTF-8 character of the text, or its first byte if it does not begin with valid
// UTF-8. The text must not be empty.
std::string_view first_character(std::string_view text);

// Returns the text in a form that is safe to print on a terminal: control characters and bytes that
// are not valid UTF-8 become escapes such as \x1b. Characters in `kept` remain as they are.
std::string printable(std::string_view text, std::string_view kept = {});

} // namespace tractus
