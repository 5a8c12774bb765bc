#pragma once

#include "engine/base/result.h"
#include "engine/variation/growth_law.h"

#include <span>
#include <string_view>

namespace tractus::variation {

// A named set of growth parameters.
struct GrowthPreset {
    std::string_view name;
    std::string_view description; // A few words, in lower case.
    GrowthParameters parameters;
};

// The presets "as drawn", "calm", "usual", "windy hillside", "storm-bent", "towards the light",
// "weeping", "winding" and "wild", in order of increasing variation.
std::span<GrowthPreset const> growth_presets();

// Finds a preset by name, ignoring case; a hyphen may replace a space. Fails with a list of names
// if there is none.
Result<GrowthParameters> growth_preset(std::string_view name);

// Returns the name of the preset with these parameters, or an empty string if there is none.
std::string_view growth_preset_of(GrowthParameters const& parameters);

} // namespace tractus::variation
