#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Splits DeviceInfo::settings at its commas; an empty text gives no words.
std::vector<std::string_view> split_settings(std::string_view settings);

// Parses a word that is a decimal number between a prefix and a suffix: 3 for "AIN", "AIN3", "". No
// value if the word is anything else.
std::optional<int> number_between(std::string_view prefix, std::string_view word,
                                  std::string_view suffix);

} // namespace tractus::drivers
