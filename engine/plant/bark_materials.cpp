#include "engine/plant/bark_materials.h"

namespace tractus {

BarkMaterials add_bark(Plant& plant, MaterialId bark, BarkKind kind)
{
    BarkMaterials made { kind, { bark, bark, bark } };
    if (kind == BarkKind::Furrowed)
        return made;
    Vec3f const color = plant.materials.at(bark).base_color;
    auto const material = [&](char const* name, BarkAge age) {
        Bark const look { kind, age };
        Vec3f const tint = color.cwiseQuotient(bark_color({ kind, BarkAge::Old }));
        return Material { .name = name,
                          .base_color = tint.cwiseProduct(bark_color(look)).cwiseMin(1.0F),
                          .roughness = 1, // Multiplied by the pictures' roughness.
                          .bark = look };
    };
    plant.materials[bark] = material("bark", BarkAge::Old);
    auto const next = static_cast<MaterialId>(plant.materials.size());
    plant.materials.push_back(material("young bark", BarkAge::Young));
    plant.materials.push_back(material("half-old bark", BarkAge::Half));
    made.of_age = { next, static_cast<MaterialId>(next + 1), bark };
    return made;
}

} // namespace tractus
