#include "engine/lsystem/text/user_text.h"

#include "engine/base/printable.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <vector>

namespace tractus::lsystem {

std::string shown(std::string_view text)
{
    constexpr std::size_t kMax = 60;
    std::string result;
    while (!text.empty() && result.size() < kMax) {
        auto const character = first_character(text);
        result += printable(character);
        text.remove_prefix(character.size());
    }
    return text.empty() ? result : result + "...";
}

// Returns the edit distance of two texts: the least number of characters to add, remove, change or
// swap to turn one into the other.
static std::size_t distance(std::string_view a, std::string_view b)
{
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t k = 1; k <= b.size(); ++k) {
            row[k] = std::min(
                { row[k - 1] + 1, last[k] + 1, last[k - 1] + (a[i - 1] != b[k - 1] ? 1u : 0u) });
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                row[k] = std::min(row[k], before[k - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string_view nearest_word(std::string_view text, std::span<std::string_view const> words)
{
    constexpr std::size_t kLongest = 40;
    if (text.size() > kLongest)
        return {};
    auto const lower = [](std::string_view word) {
        std::string result(word);
        std::transform(result.begin(), result.end(), result.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return result;
    };
    auto const sought = lower(text);
    std::string_view nearest;
    std::size_t least = kLongest;
    for (auto const word : words) {
        auto const far = distance(sought, lower(word));
        if (far == 0)
            return {};
        if (far < least && far <= std::max<std::size_t>(word.size() / 4, 1)) {
            least = far;
            nearest = word;
        }
    }
    return nearest;
}

std::string_view nearest_beginning(std::string_view line, std::span<std::string_view const> words)
{
    if (auto const whole = nearest_word(line, words); !whole.empty())
        return whole;
    if (auto const colon = line.find(':'); colon != std::string_view::npos)
        return nearest_word(line.substr(0, colon + 1), words);
    for (auto blank = line.rfind(' '); blank != std::string_view::npos && blank > 0;
         blank = line.rfind(' ', blank - 1))
        for (auto const* const end : { "", ":" }) // The user may have forgotten the colon.
            if (auto const meant = nearest_word(std::string(line.substr(0, blank)) + end, words);
                !meant.empty())
                return meant;
    return {};
}

} // namespace tractus::lsystem
