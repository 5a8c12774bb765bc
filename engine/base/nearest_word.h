#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus {

// Returns the word of `words` that the typed word was probably meant to be: the one at the smallest
// restricted Damerau-Levenshtein distance (letters inserted, left out, replaced, or swapped with
// their neighbour; capitals ignored), and the first of equally near ones. The distance may be at
// most a third of the typed letters, and may always be one. Returns no value if every word is
// further away.
std::optional<std::string> nearest_word(std::string_view typed, std::span<std::string const> words);

// Returns " (did you mean birch?)", to append to the unknown word in a message, or an empty string.
std::string did_you_mean(std::string_view typed, std::span<std::string const> words);

} // namespace tractus
