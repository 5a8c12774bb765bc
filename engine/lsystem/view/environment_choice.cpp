#include "engine/lsystem/view/environment_choice.h"

#include "engine/lsystem/text/user_text.h"
#include "engine/lsystem/view/view_reader.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <limits>
#include <span>

namespace tractus::lsystem {

namespace {

struct Number {
    std::string_view key;
    double value; // Value of the parameter if it is not given.
    double least;
    double most;
};
struct Kind {
    std::string_view name;
    std::span<Number const> numbers;
};

constexpr double kAny = 1e9;
constexpr double kSmall = 1e-6;
constexpr std::array kLight { Number { "cell", 1, kSmall, kAny }, Number { "shade", 0.2, 0, kAny },
                              Number { "decay", 2, 1, kAny }, Number { "depth", 8, 1, 100 },
                              Number { "full", 1, 0, kAny } };
constexpr std::array kSpace { Number { "radius", 1, kSmall, kAny } };
constexpr std::array kTerrain { Number { "slope", 0, -89, 89 }, Number { "hill", 0, -kAny, kAny },
                                Number { "wave", 10, kSmall, kAny } };
constexpr std::array kWater { Number { "cell", 1, kSmall, kAny }, Number { "content", 1, 0, kAny },
                              Number { "uptake", 0.1, 0, kAny },
                              Number { "diffusion", 0.1, 0, 1.0 / 6 } };
constexpr std::array kEnvironments { Kind { "light", kLight }, Kind { "space", kSpace },
                                     Kind { "terrain", kTerrain }, Kind { "water", kWater } };

constexpr std::string_view kSeparators = " \t:,";

Kind const* find(std::string_view name)
{
    auto const found = std::find_if(kEnvironments.begin(), kEnvironments.end(),
                                    [&](Kind const& kind) { return kind.name == name; });
    return found == kEnvironments.end() ? nullptr : &*found;
}

Result<void> set_number(Kind const& kind, std::string_view word, EnvironmentChoice& choice)
{
    auto const equals = std::min(word.find('='), word.size());
    auto const key = word.substr(0, equals);
    auto const known = std::find_if(kind.numbers.begin(), kind.numbers.end(),
                                    [&](Number const& entry) { return entry.key == key; });
    if (known == kind.numbers.end()) {
        std::string keys;
        for (auto const& entry : kind.numbers)
            keys += fmt::format("{}{}=", keys.empty() ? "" : ", ", entry.key);
        return fail(Fault::User,
                    fmt::format("environment {}: found '{}', expected one of {}", kind.name,
                                shown(word), keys));
    }
    auto const value = number(word.substr(std::min(equals + 1, word.size())));
    if (!value || *value < known->least || *value > known->most)
        return fail(Fault::User,
                    fmt::format("environment {}: found '{}', expected a number of {} to {:.4g}",
                                kind.name, shown(word), known->least, known->most));
    choice.values[std::string(key)] = *value;
    return {};
}

} // namespace

bool names_environment(std::string_view text)
{
    auto const parts = words(text, kSeparators);
    return !parts.empty() && find(parts.front());
}

Result<EnvironmentChoice> parse_environment(std::string_view text)
{
    auto const parts = words(text, kSeparators);
    auto const* const kind = parts.empty() ? nullptr : find(parts.front());
    if (!kind)
        return fail(Fault::User,
                    fmt::format("there is no environment '{}'; there are light, space, terrain and "
                                "water",
                                shown(text)));
    EnvironmentChoice choice;
    choice.name = kind->name;
    for (auto const& entry : kind->numbers)
        choice.values[std::string(entry.key)] = entry.value;
    for (auto const word : std::span(parts).subspan(1))
        TRY(set_number(*kind, word, choice));
    return choice;
}

} // namespace tractus::lsystem
