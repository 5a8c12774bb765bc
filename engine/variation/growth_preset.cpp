#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>
#include <string>

namespace tractus::variation {

static std::array<GrowthPreset, 9> make_presets()
{
    return { {
        { "as drawn", "the strokes and nothing else", { .strength = 0, .indicator_gain = 0 } },
        { "calm",
          "a sheltered garden: twigs differ, branches hardly",
          { .gain = 0.3, .noise_rad = 0.018, .noise_memory = 0.3 } },
        { "usual", "as plants of one kind differ", {} },
        { "windy hillside",
          "leans with the wind, and grows crooked",
          { .gain = 0.15,
            .noise_rad = 0.04,
            .prevailing = { 0.7, 0.15, 0 },
            .growth_zone_steps = 6,
            .maturation_bending = 0.006,
            .sag = 1 } },
        { "storm-bent",
          "a crown that the wind has combed to one side",
          { .gain = 0.08,
            .noise_rad = 0.05,
            .prevailing = { 1.3, 0.2, -0.1 },
            .growth_zone_steps = 8,
            .maturation_bending = 0.01,
            .sag = 1 } },
        { "towards the light",
          "every tip turns up as it grows",
          { .gain = 0.1,
            .prevailing = { 0, 0, 1 },
            .growth_zone_steps = 8,
            .maturation_bending = 0.012 } },
        { "weeping",
          "every branch turns down as it grows, and hangs",
          { .gain = 0.18,
            .noise_rad = 0.03,
            .prevailing = { 0, 0, -1 },
            .growth_zone_steps = 8,
            .maturation_bending = 0.012 } },
        { "winding",
          "tips circle and overshoot",
          { .gain = 0.15,
            .delay_steps = 1,
            .noise_rad = 0.03,
            .circumnutation_rad = radians(6),
            .circumnutation_period_steps = 9 } },
        { "wild",
          "follows the strokes only from afar",
          { .gain = 0.06, .delay_steps = 1, .noise_rad = 0.08, .noise_memory = 0.7, .sag = 3 } },
    } };
}

std::span<GrowthPreset const> growth_presets()
{
    static auto const presets = make_presets();
    return presets;
}

static std::string plain(std::string_view name)
{
    std::string result;
    for (char const letter : name)
        result += letter == '-' || letter == '_'
            ? ' '
            : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return result;
}

Result<GrowthParameters> growth_preset(std::string_view name)
{
    std::string names;
    for (auto const& preset : growth_presets()) {
        if (plain(preset.name) == plain(name))
            return preset.parameters;
        names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", preset.name);
    }
    return fail(Fault::User,
                fmt::format("plants cannot grow \"{}\": they can grow {}", name, names));
}

std::string_view growth_preset_of(GrowthParameters const& parameters)
{
    auto const presets = growth_presets();
    auto const found = std::find_if(presets.begin(), presets.end(), [&](auto const& preset) {
        return preset.parameters == parameters;
    });
    return found == presets.end() ? std::string_view {} : found->name;
}

} // namespace tractus::variation
