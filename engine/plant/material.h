#pragma once

#include "engine/base/vectors.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tractus {

// Index into Plant::materials.
using MaterialId = std::uint16_t;

// A picture on a surface, and what is beyond its edges.
struct TexturePicture {
    std::string bytes; // Of a PNG file; of a JPEG file where another program made it.
    enum class Edges { Repeat, Clamp } edges = Edges::Repeat;
};

// Shared by all copies of a material, since plants are copied often; none where it is null.
using TextureSlot = std::shared_ptr<TexturePicture const>;

// Pictures that say more of a surface than its numbers do, and multiply them. In the texture
// coordinates of meshes (engine/mesh/mesh.h), rows along v, the first at v = 0.
struct MaterialTextures {
    TextureSlot base_color {};    // sRGB, and alpha if the picture has it.
    TextureSlot normal {};        // Normals in tangent space; green points against v.
    TextureSlot occlusion {};     // Red: sky that is seen. Mostly the picture of roughness.
    TextureSlot roughness {};     // Green: roughness; blue: metal.
    TextureSlot translucency {};  // Alpha: how much light passes.
    float normal_strength = 1;    // Multiplies the slopes of normal.
    float occlusion_strength = 1; // Share of occlusion that counts, 0 to 1.

    // Whether what is less than half there by base_color's alpha is not there at all.
    enum class Alpha { Opaque, Mask } alpha = Alpha::Opaque;

    // Whether base_color multiplies the material's own colour or stands for it: then that is the
    // picture's mean, for who shows no pictures.
    enum class Color { Multiplied, Replaced } color = Color::Multiplied;
};

// How a surface looks: enough for the renderer and for glTF's metallic-roughness model. Plants are
// not metallic; pots are.
struct Material {
    enum class Kind {
        Bark,  // Opaque tubes; the renderer and the texture maker roughen it along the axis.
        Stem,  // Opaque tubes, smooth and green: herbs and petioles.
        Leaf,  // Thin, seen from both sides, lets light through.
        Petal, // Like Leaf, without veins.
        Solid, // Fruit, buds, flower centres.
    };

    std::string name = "bark";
    Kind kind = Kind::Bark;
    Vec3f base_color { 0.31f, 0.23f, 0.16f }; // sRGB as people write it, 0 to 1.
    float roughness = 0.9f;                   // 0 to 1, as in glTF 2.0 section 3.9.2.
    float metalness = 0;                      // Likewise; other programs' files alone have metal.
    float translucency = 0; // Share of light that passes through, 0 to 1; Leaf and Petal only.
    MaterialTextures textures {}; // Missing ones are the exporter's own for the kind.
};

} // namespace tractus
