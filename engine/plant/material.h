#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/bark.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tractus {

// Index into Plant::materials.
using MaterialId = std::uint16_t;

// A texture picture and how it continues beyond its edges.
struct TexturePicture {
    std::string bytes; // Contents of a PNG file; imported materials may have a JPEG file instead.
    enum class Edges { Repeat, Clamp } edges = Edges::Repeat;
};

// A picture, shared by all copies of a material, since plants are copied often; null: no picture.
using TextureSlot = std::shared_ptr<TexturePicture const>;

// Texture pictures that refine a material; their values are multiplied with the material's numbers.
// They use the texture coordinates of meshes (engine/mesh/mesh.h); the first row of a picture is at
// v = 0.
struct MaterialTextures {
    TextureSlot base_color {}; // sRGB, with alpha if the picture has it.
    TextureSlot normal {};     // Tangent-space normals; green points towards -v.
    // Red channel: visible share of the sky (ambient occlusion). Usually the same picture as
    // roughness.
    TextureSlot occlusion {};
    TextureSlot roughness {};     // Green channel: roughness; blue channel: metalness.
    TextureSlot translucency {};  // Alpha channel: share of light that passes through.
    float normal_strength = 1;    // Factor on the slopes of the normal map.
    float occlusion_strength = 1; // Weight of the occlusion map, 0 to 1.

    // Mask: parts where base_color's alpha is below one half are not drawn.
    enum class Alpha { Opaque, Mask } alpha = Alpha::Opaque;

    // Multiplied: the picture multiplies the material's base_color. Replaced: the picture replaces
    // it; base_color is then the mean of the picture, for programs that show no pictures.
    enum class Color { Multiplied, Replaced } color = Color::Multiplied;
};

// Appearance of a surface: the parameters of the renderer and of glTF's metallic-roughness model.
// Plants are not metallic; pots may be.
struct Material {
    enum class Kind {
        Bark,  // Opaque tubes with furrows along the axis (renderer; engine/export/texture.h).
        Stem,  // Opaque tubes, smooth and green: stems of herbs, petioles.
        Leaf,  // Thin, two-sided, translucent.
        Petal, // Like Leaf, without veins.
        Solid, // Fruit, buds, flower centres.
    };

    std::string name = "bark";
    Kind kind = Kind::Bark;
    Vec3f base_color { 0.31f, 0.23f, 0.16f }; // sRGB (not linear), 0 to 1.
    float roughness = 0.9f;                   // 0 to 1, as in glTF 2.0 section 3.9.2.
    // 0 to 1, as in glTF 2.0 section 3.9.2. Only imported materials are metallic.
    float metalness = 0;
    Bark bark {};           // For Kind::Bark only: which pictures are generated where it has none.
    float translucency = 0; // Share of light that passes through, 0 to 1; for Leaf and Petal only.
    // If a picture is missing, the exporter generates one for the kind of material.
    MaterialTextures textures {};
};

} // namespace tractus
