#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tractus {

// The word among `words` that was probably meant by `typed`: the one with the fewest letters
// inserted, left out, replaced or swapped with their neighbour (restricted Damerau-Levenshtein
// distance, capitals ignored), the first of equals. At most a third of the typed letters may be
// wrong, and at least one. No value if every word differs by more.
std::optional<std::string> nearest_word(std::string_view typed, std::span<std::string const> words);

// " (did you mean birch?)" to follow what was typed in a sentence, or nothing.
std::string did_you_mean(std::string_view typed, std::span<std::string const> words);

} // namespace tractus
