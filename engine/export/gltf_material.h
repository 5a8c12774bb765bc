#pragma once

#include "engine/plant/material.h"

#include <optional>
#include <string_view>

namespace tractus::exports {

// The linear value of an sRGB one, and back (IEC 61966-2-1). 0 to 1.
double linear_from_srgb(double srgb);
double srgb_from_linear(double linear);

// A colour's linear light; what is beyond 0 to 1 is taken for the nearest.
Vec3 linear_color(Vec3f const& srgb);

// The word for a kind in a glTF material's extras, and the kind for a word.
std::string_view kind_word(Material::Kind kind);
std::optional<Material::Kind> kind_of_word(std::string_view word);

} // namespace tractus::exports
