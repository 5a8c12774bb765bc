#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <string>

namespace tractus {

// Index into Plant::materials.
using MaterialId = std::uint16_t;

// How a surface looks: enough for the renderer and for glTF's metallic-roughness model, in which
// plants are not metallic.
struct Material {
    enum class Kind {
        Bark,  // Opaque tubes; the renderer and the texture maker roughen it along the axis.
        Stem,  // Opaque tubes, smooth and green: herbs and petioles.
        Leaf,  // Thin, seen from both sides, lets light through.
        Petal, // As Leaf, without veins.
        Solid, // Fruit, buds, flower centres.
    };

    std::string name = "bark";
    Kind kind = Kind::Bark;
    Vec3f base_color { 0.31f, 0.23f, 0.16f }; // sRGB as people write it, 0 to 1.
    float roughness = 0.9f;                   // 0 to 1, as in glTF 2.0 section 3.9.2.
    float translucency = 0; // Share of light that passes through, 0 to 1; Leaf and Petal only.
};

} // namespace tractus
