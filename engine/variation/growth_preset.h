#pragma once

#include "engine/base/result.h"
#include "engine/variation/growth_law.h"

#include <span>
#include <string_view>

namespace tractus::variation {

// A named set of growth parameters.
struct GrowthPreset {
    std::string_view name;
    std::string_view description; // A phrase in lower case, for lists of presets.
    GrowthParameters parameters;
};

// The presets "as drawn", "calm", "usual", "windy hillside", "storm-bent", "towards the light",
// "weeping", "winding" and "wild", in order of increasing variation.
std::span<GrowthPreset const> growth_presets();

// Returns the parameters of a preset. Case is ignored in `name`; hyphens and underscores count as
// spaces. If there is no such preset, fails with a list of all names.
Result<GrowthParameters> growth_preset(std::string_view name);

// Returns the name of the preset with exactly these parameters; an empty string if there is none.
std::string_view growth_preset_of(GrowthParameters const& parameters);

} // namespace tractus::variation
