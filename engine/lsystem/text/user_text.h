#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// A user's text for a message, as printable() has it; long text cut.
std::string shown(std::string_view text);

// The word that the text was perhaps meant to be, in either case; empty if none is near, or
// the text is one of them.
std::string_view nearest_word(std::string_view text, std::span<std::string_view const> words);

// The words with which a line perhaps was meant to begin; empty if none are near, or the line
// begins with one of them.
std::string_view nearest_beginning(std::string_view line, std::span<std::string_view const> words);

} // namespace tractus::lsystem
