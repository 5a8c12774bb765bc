#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Formats a text of the user's for a message, as printable() does, and shortens it if it is long.
std::string shown(std::string_view text);

// Returns the word that a text is probably a misspelling of, ignoring case. Empty if no word is
// similar or the text is one of the words.
std::string_view nearest_word(std::string_view text, std::span<std::string_view const> words);

// Returns the entry of `words` that the beginning of a line is probably a misspelling of. Empty if
// none is similar or the line begins with one of them.
std::string_view nearest_beginning(std::string_view line, std::span<std::string_view const> words);

} // namespace tractus::lsystem
