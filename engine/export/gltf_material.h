#pragma once

#include "engine/plant/material.h"

#include <optional>
#include <string_view>

namespace tractus::exports {

// Convert an sRGB value to linear light and back (IEC 61966-2-1); both from 0 to 1.
double linear_from_srgb(double srgb);
double srgb_from_linear(double linear);

// Converts a colour to linear light, clamped to 0 to 1.
Vec3 linear_color(Vec3f const& srgb);

// True for materials of which both sides are seen: leaves and petals are a single layer.
bool is_thin(Material::Kind kind);

// Convert a material kind to its name in the extras of a glTF material, and back; no value for an
// unknown name.
std::string_view material_kind_name(Material::Kind kind);
std::optional<Material::Kind> parse_material_kind(std::string_view word);

} // namespace tractus::exports
