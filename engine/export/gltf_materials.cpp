#include "engine/export/gltf_materials.h"

#include "engine/export/glb_column.h"
#include "engine/export/gltf_material.h"
#include "engine/export/texture.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <string>

namespace tractus::exports {
namespace {

// Texture filters and wrapping modes (glTF 2.0 section 3.8.4).
constexpr int kLinear = 9729;
constexpr int kLinearMipmapLinear = 9987;
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;

// Rounds to six significant digits, so that the float 0.3 is not written as 0.30000001192092896.
double six_digits(double value)
{
    auto const text = fmt::format("{:.6g}", value);
    double read = 0;
    std::from_chars(text.data(), text.data() + text.size(), read);
    return read;
}

} // namespace

GltfMaterials::GltfMaterials(GltfJson& json, GlbStream& stream, bool has_textures, int bark_px)
    : json_(json)
    , stream_(stream)
    , has_textures_(has_textures)
    , bark_px_(bark_px)
{
}

std::size_t GltfMaterials::index_of(Material const& material)
{
    MaterialTextures textures;
    if (has_textures_)
        textures = textures_of(material, bark_px_);
    Vec3 const color
        = has_textures_ ? multiplied_color(material, bark_px_) : linear_color(material.base_color);
    Json made {
        { "name", material.name },
        { "pbrMetallicRoughness",
          { { "baseColorFactor",
              { six_digits(color.x()), six_digits(color.y()), six_digits(color.z()), 1 } },
            { "metallicFactor", 0 },
            { "roughnessFactor", six_digits(std::clamp(material.roughness, 0.0f, 1.0f)) } } },
    };
    auto& pbr = made["pbrMetallicRoughness"];
    refer(pbr, "baseColorTexture", textures.base_color);
    refer(pbr, "metallicRoughnessTexture", textures.roughness);
    refer(made, "normalTexture", textures.normal);
    if (textures.normal && textures.normal_strength != 1)
        made["normalTexture"]["scale"] = six_digits(textures.normal_strength);
    refer(made, "occlusionTexture", textures.occlusion);
    if (textures.occlusion && textures.occlusion_strength != 1)
        made["occlusionTexture"]["strength"] = six_digits(textures.occlusion_strength);
    if (textures.alpha == MaterialTextures::Alpha::Mask)
        made["alphaMode"] = "MASK";
    if (is_thin(material.kind))
        made["doubleSided"] = true;
    if (textures.translucency || (is_thin(material.kind) && material.translucency > 0)) {
        json_.optional_extensions.insert("KHR_materials_diffuse_transmission");
        auto& passes = made["extensions"]["KHR_materials_diffuse_transmission"];
        passes["diffuseTransmissionFactor"]
            = six_digits(std::clamp(material.translucency, 0.0f, 1.0f));
        refer(passes, "diffuseTransmissionTexture", textures.translucency);
    }
    made["extras"]
        = { { "kind", material_kind_name(material.kind) },
            { "translucency", six_digits(std::clamp(material.translucency, 0.0f, 1.0f)) } };
    auto const [place, is_new] = indices_.emplace(json_text(made), json_.materials.count());
    if (is_new)
        json_.materials.add(made);
    return place->second;
}

// Adds the member `name` to `to`, which refers to the picture's texture. The picture is written to
// the file when it is first used.
void GltfMaterials::refer(Json& to, char const* name, TextureSlot const& slot)
{
    if (!slot)
        return;
    auto const known = textures_.find(slot->bytes);
    auto const index
        = known != textures_.end() ? known->second : add_texture(slot->bytes, slot->edges);
    textures_.emplace(slot->bytes, index);
    to[name] = { { "index", index } };
}

std::size_t GltfMaterials::add_texture(std::string_view bytes, TexturePicture::Edges edges)
{
    int const wrap = edges == TexturePicture::Edges::Repeat ? kRepeat : kClampToEdge;
    auto block = stream_.open_block(bytes.size());
    stream_.write(block, std::as_bytes(std::span(bytes)));
    bool const is_jpeg = bytes.starts_with("\xff\xd8");
    auto const image = json_.images.add({ { "bufferView", add_view(json_, block) },
                                          { "mimeType", is_jpeg ? "image/jpeg" : "image/png" } });
    auto const sampler = json_.samplers.add({ { "magFilter", kLinear },
                                              { "minFilter", kLinearMipmapLinear },
                                              { "wrapS", wrap },
                                              { "wrapT", wrap } });
    return json_.textures.add({ { "sampler", sampler }, { "source", image } });
}

std::size_t GltfMaterials::add_picture(std::string_view png)
{
    json_.optional_extensions.insert("KHR_materials_unlit");
    Json const picture { { "index", add_texture(png, TexturePicture::Edges::Clamp) } };
    return json_.materials.add({
        { "name", "billboard" },
        { "pbrMetallicRoughness",
          { { "baseColorTexture", picture }, { "metallicFactor", 0 }, { "roughnessFactor", 1 } } },
        { "alphaMode", "MASK" },
        { "extensions", { { "KHR_materials_unlit", Json::object() } } },
    });
}

} // namespace tractus::exports
