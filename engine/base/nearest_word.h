#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus {

// Returns the word of `words` that the user probably meant by the typed word: the one at the
// smallest restricted Damerau-Levenshtein distance (letters inserted, left out, replaced, or
// swapped with their neighbour; capitals ignored), or the first of several at that distance. The
// distance must be at most 1, or at most a third of the number of typed letters if that is more.
// Returns no value if every word is further away.
std::optional<std::string> nearest_word(std::string_view typed, std::span<std::string const> words);

// Returns " (did you mean birch?)", to append to an unknown word in a message, or an empty string
// if no word is near.
std::string did_you_mean(std::string_view typed, std::span<std::string const> words);

} // namespace tractus
