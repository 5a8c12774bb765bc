#pragma once

#include "engine/base/result.h"
#include "engine/variation/growth_law.h"

#include <span>
#include <string_view>

namespace tractus::variation {

// Growth by a name that people understand.
struct GrowthPreset {
    std::string_view name;
    std::string_view description; // A few words, lower case.
    GrowthParameters parameters;
};

// "as drawn", "calm", "usual", "windy hillside", "storm-bent", "towards the light", "weeping",
// "winding" and "wild", from the tamest to the wildest.
std::span<GrowthPreset const> growth_presets();

// Refuses, naming those there are, a name that is none. Case does not matter, and a hyphen is as
// good as a blank.
Result<GrowthParameters> growth_preset(std::string_view name);

// The name of the preset that these are; empty if they are none's.
std::string_view growth_preset_of(GrowthParameters const& parameters);

} // namespace tractus::variation
