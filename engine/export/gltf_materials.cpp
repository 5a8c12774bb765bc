#include "engine/export/gltf_materials.h"

#include "engine/export/gltf_material.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus {
namespace {

// glTF 2.0 section 3.8.4.
constexpr int kRepeat = 10497;
constexpr int kClampToEdge = 33071;

bool is_thin(Material::Kind kind)
{
    return kind == Material::Kind::Leaf || kind == Material::Kind::Petal;
}

} // namespace

GltfMaterials::GltfMaterials(GltfJson& json, GlbStream& stream, bool has_textures)
    : json_(json)
    , stream_(stream)
    , has_textures_(has_textures)
{
}

std::size_t GltfMaterials::index_of(Material const& material)
{
    std::string texture;
    if (has_textures_ && material.kind == Material::Kind::Bark)
        texture = texture_reference(bark_texture_, bark_picture, kRepeat);
    else if (has_textures_ && material.kind == Material::Kind::Leaf)
        texture = texture_reference(leaf_texture_, leaf_picture, kClampToEdge);
    auto const color = material.base_color.cwiseMax(0.0f).cwiseMin(1.0f).cast<double>().eval();
    auto const text = fmt::format(
        "{{\"name\":{},\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{:.6g},{:.6g},{:.6g},1],"
        "\"metallicFactor\":0,\"roughnessFactor\":{}{}}}{},\"extras\":{{\"kind\":\"{}\","
        "\"translucency\":{}}}}}",
        quoted(material.name), linear_from_srgb(color.x()), linear_from_srgb(color.y()),
        linear_from_srgb(color.z()), std::clamp(material.roughness, 0.0f, 1.0f), texture,
        is_thin(material.kind) ? ",\"doubleSided\":true" : "", kind_word(material.kind),
        std::clamp(material.translucency, 0.0f, 1.0f));
    auto const [place, is_new] = indices_.emplace(text, json_.materials.count());
    if (is_new)
        json_.materials.add(text);
    return place->second;
}

std::size_t GltfMaterials::add_texture(std::string_view png, int wrap)
{
    auto block = stream_.open_block(png.size());
    stream_.write(block, std::as_bytes(std::span(png)));
    auto const view = json_.buffer_views.add(fmt::format(
        "{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{}}}", block.start, block.size));
    auto const image
        = json_.images.add(fmt::format("{{\"bufferView\":{},\"mimeType\":\"image/png\"}}", view));
    auto const sampler = json_.samplers.add(
        fmt::format("{{\"magFilter\":9729,\"minFilter\":9987,\"wrapS\":{0},\"wrapT\":{0}}}", wrap));
    return json_.textures.add(fmt::format("{{\"sampler\":{},\"source\":{}}}", sampler, image));
}

std::size_t GltfMaterials::add_picture(std::string_view png)
{
    json_.optional_extensions.insert("KHR_materials_unlit");
    return json_.materials.add(fmt::format(
        "{{\"name\":\"billboard\",\"pbrMetallicRoughness\":{{\"baseColorTexture\":{{\"index\":{}}},"
        "\"metallicFactor\":0,\"roughnessFactor\":1}},\"alphaMode\":\"MASK\","
        "\"extensions\":{{\"KHR_materials_unlit\":{{}}}}}}",
        add_texture(png, kClampToEdge)));
}

// Puts the picture into the file when it is first asked for.
std::string GltfMaterials::texture_reference(std::optional<std::size_t>& index,
                                             GreyPicture (*picture)(), int wrap)
{
    if (!index)
        index = add_texture(png_bytes(picture()), wrap);
    return fmt::format(",\"baseColorTexture\":{{\"index\":{}}}", *index);
}

} // namespace tractus
