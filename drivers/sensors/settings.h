#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// The words of DeviceInfo::settings, which stand between commas; none of an empty text.
std::vector<std::string_view> split_settings(std::string_view settings);

// The decimal number between two ends of a word: 3 for "AIN3" and "AIN", "". No value if the word
// is anything else.
std::optional<int> number_between(std::string_view prefix, std::string_view word,
                                  std::string_view suffix);

} // namespace tractus::drivers
