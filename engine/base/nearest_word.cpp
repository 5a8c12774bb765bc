#include "engine/base/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <fmt/core.h>
#include <numeric>
#include <vector>

namespace tractus {

static bool is_same_letter(char a, char b)
{
    return std::tolower(static_cast<unsigned char>(a))
        == std::tolower(static_cast<unsigned char>(b));
}

// Returns the restricted Damerau-Levenshtein distance of two words, computed row by row.
static std::size_t edit_distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before_last(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t(0));
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            auto const replaced = last[j - 1] + !is_same_letter(a[i - 1], b[j - 1]);
            row[j] = std::min({ last[j] + 1, row[j - 1] + 1, replaced });
            if (i > 1 && j > 1 && is_same_letter(a[i - 1], b[j - 2])
                && is_same_letter(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        before_last.swap(last);
        last.swap(row);
    }
    return last[b.size()];
}

std::optional<std::string> nearest_word(std::string_view typed, std::span<std::string const> words)
{
    constexpr std::size_t kLongestWord = 64; // Longer input is not taken for a mistyped word.
    if (typed.empty() || typed.size() > kLongestWord)
        return std::nullopt;
    std::string const* nearest = nullptr;
    auto least = std::max<std::size_t>(1, typed.size() / 3) + 1;
    for (auto const& word : words) {
        if (word.size() > kLongestWord)
            continue;
        if (auto const distance = edit_distance(typed, word); distance < least) {
            least = distance;
            nearest = &word;
        }
    }
    return nearest ? std::optional(*nearest) : std::nullopt;
}

std::string did_you_mean(std::string_view typed, std::span<std::string const> words)
{
    auto const nearest = nearest_word(typed, words);
    return nearest ? fmt::format(" (did you mean {}?)", *nearest) : std::string();
}

} // namespace tractus
