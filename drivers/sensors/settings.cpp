#include "drivers/sensors/settings.h"

#include <charconv>

namespace tractus::drivers {

std::vector<std::string_view> split_settings(std::string_view settings)
{
    std::vector<std::string_view> words;
    while (!settings.empty()) {
        auto const comma = settings.find(',');
        words.push_back(settings.substr(0, comma));
        settings
            = comma == std::string_view::npos ? std::string_view() : settings.substr(comma + 1);
    }
    return words;
}

std::optional<int> number_between(std::string_view prefix, std::string_view word,
                                  std::string_view suffix)
{
    if (!word.starts_with(prefix) || !word.ends_with(suffix)
        || word.size() <= prefix.size() + suffix.size())
        return std::nullopt;
    auto const digits = word.substr(prefix.size(), word.size() - prefix.size() - suffix.size());
    int value = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < 0)
        return std::nullopt;
    return value;
}

} // namespace tractus::drivers
