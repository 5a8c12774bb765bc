#include "engine/export/material_names.h"

#include <fmt/format.h>
#include <utility>

namespace tractus::exports {

MaterialNames::MaterialNames(std::function<std::string(std::string const&)> word, char mark)
    : word_(std::move(word))
    , mark_(mark)
{
}

MaterialNames::Named MaterialNames::name_of(Material const& material)
{
    auto const key = key_of(material);
    if (auto const known = names_.find(key); known != names_.end())
        return { known->second, false };
    auto name = unused_name(word_(material.name));
    names_.emplace(key, name);
    return { std::move(name), true };
}

MaterialNames::Key MaterialNames::key_of(Material const& material)
{
    auto const& color = material.base_color;
    auto const& pictures = material.textures;
    return { material.name,
             material.kind,
             { color.x(), color.y(), color.z(), material.roughness, material.metalness,
               material.translucency, pictures.normal_strength, pictures.occlusion_strength },
             { pictures.base_color.get(), pictures.normal.get(), pictures.occlusion.get(),
               pictures.roughness.get(), pictures.translucency.get() },
             pictures.alpha,
             pictures.color,
             material.bark };
}

std::string MaterialNames::unused_name(std::string const& word)
{
    auto name = word;
    for (int number = 2; !used_.insert(name).second; ++number)
        name = fmt::format("{}{}{}", word, mark_, number);
    return name;
}

} // namespace tractus::exports
