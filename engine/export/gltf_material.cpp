#include "engine/export/gltf_material.h"

#include <array>
#include <cmath>
#include <utility>

namespace tractus::exports {

using KindWord = std::pair<Material::Kind, std::string_view>;

static constexpr std::array<KindWord, 5> kKindWords { {
    { Material::Kind::Bark, "bark" },
    { Material::Kind::Stem, "stem" },
    { Material::Kind::Leaf, "leaf" },
    { Material::Kind::Petal, "petal" },
    { Material::Kind::Solid, "solid" },
} };

double linear_from_srgb(double srgb)
{
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double linear)
{
    return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Vec3 linear_color(Vec3f const& srgb)
{
    return srgb.cwiseMax(0.0f).cwiseMin(1.0f).cast<double>().unaryExpr(&linear_from_srgb);
}

bool is_thin(Material::Kind kind)
{
    return kind == Material::Kind::Leaf || kind == Material::Kind::Petal;
}

std::string_view material_kind_name(Material::Kind kind)
{
    for (auto const& [known, word] : kKindWords)
        if (known == kind)
            return word;
    return "solid";
}

std::optional<Material::Kind> parse_material_kind(std::string_view word)
{
    for (auto const& [kind, known] : kKindWords)
        if (known == word)
            return kind;
    return std::nullopt;
}

} // namespace tractus::exports
