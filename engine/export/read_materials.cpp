#include "engine/export/read_materials.h"

#include "engine/export/gltf_material.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace tractus::exports {
namespace {

constexpr char const* kTransmission = "KHR_materials_diffuse_transmission";

// Returns the item at an index, or null if the index is out of range.
template<typename T> T const* item_of(std::vector<T> const& items, int index)
{
    return index >= 0 && static_cast<std::size_t>(index) < items.size()
        ? &items[static_cast<std::size_t>(index)]
        : nullptr;
}

float share(double value)
{
    return static_cast<float>(std::clamp(value, 0.0, 1.0));
}

class Reader {
public:
    explicit Reader(tinygltf::Model const& model)
        : model_(model)
    {
    }

    Material read(tinygltf::Material const& from)
    {
        Material material;
        material.name = from.name;
        auto const& surface = from.pbrMetallicRoughness;
        for (std::size_t i = 0; i < 3 && i < surface.baseColorFactor.size(); ++i)
            material.base_color[static_cast<Eigen::Index>(i)] = static_cast<float>(
                srgb_from_linear(std::clamp(surface.baseColorFactor[i], 0.0, 1.0)));
        material.roughness = share(surface.roughnessFactor);
        material.metalness = share(surface.metallicFactor);
        material.kind = from.doubleSided ? Material::Kind::Leaf : Material::Kind::Solid;
        read_pictures(from, material.textures);
        read_transmission(from, material);
        if (!from.extras.IsObject())
            return material;
        if (auto const& kind = from.extras.Get("kind"); kind.IsString())
            material.kind = parse_material_kind(kind.Get<std::string>()).value_or(material.kind);
        if (auto const& passing = from.extras.Get("translucency"); passing.IsNumber())
            material.translucency = share(passing.GetNumberAsDouble());
        return material;
    }

private:
    void read_pictures(tinygltf::Material const& from, MaterialTextures& textures)
    {
        auto const& surface = from.pbrMetallicRoughness;
        textures.base_color = picture_of(surface.baseColorTexture);
        textures.roughness = picture_of(surface.metallicRoughnessTexture);
        textures.normal = picture_of(from.normalTexture);
        textures.occlusion = picture_of(from.occlusionTexture);
        textures.normal_strength
            = static_cast<float>(std::clamp(from.normalTexture.scale, -100.0, 100.0));
        textures.occlusion_strength = share(from.occlusionTexture.strength);
        if (from.alphaMode == "MASK" || from.alphaMode == "BLEND")
            textures.alpha = MaterialTextures::Alpha::Mask;
    }

    void read_transmission(tinygltf::Material const& from, Material& material)
    {
        auto const found = from.extensions.find(kTransmission);
        if (found == from.extensions.end() || !found->second.IsObject())
            return;
        if (auto const& factor = found->second.Get("diffuseTransmissionFactor"); factor.IsNumber())
            material.translucency = share(factor.GetNumberAsDouble());
        auto const& texture = found->second.Get("diffuseTransmissionTexture");
        if (!texture.IsObject() || !texture.Get("index").IsInt())
            return;
        tinygltf::TextureInfo info;
        info.index = texture.Get("index").GetNumberAsInt();
        if (texture.Get("texCoord").IsInt())
            info.texCoord = texture.Get("texCoord").GetNumberAsInt();
        material.textures.translucency = picture_of(info);
    }

    template<typename TextureInfo> TextureSlot picture_of(TextureInfo const& info)
    {
        if (info.index < 0 || info.texCoord != 0)
            return nullptr;
        auto const [place, is_new] = pictures_.try_emplace(info.index);
        if (is_new)
            place->second = read_picture(info.index);
        return place->second;
    }

    // Returns the picture of a texture; null if the picture is neither PNG nor JPEG, or is not in
    // the file itself.
    TextureSlot read_picture(int texture) const
    {
        auto const* const from = item_of(model_.textures, texture);
        auto const* const image = from ? item_of(model_.images, from->source) : nullptr;
        auto const* const view = image ? item_of(model_.bufferViews, image->bufferView) : nullptr;
        auto const* const buffer = view ? item_of(model_.buffers, view->buffer) : nullptr;
        if (!buffer || (image->mimeType != "image/png" && image->mimeType != "image/jpeg")
            || view->byteOffset > buffer->data.size()
            || view->byteLength > buffer->data.size() - view->byteOffset)
            return nullptr;
        auto const* const sampler = item_of(model_.samplers, from->sampler);
        TexturePicture picture;
        if (sampler && sampler->wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE)
            picture.edges = TexturePicture::Edges::Clamp;
        auto const* const bytes = reinterpret_cast<char const*>(buffer->data.data());
        picture.bytes.assign(bytes + view->byteOffset, view->byteLength);
        return std::make_shared<TexturePicture const>(std::move(picture));
    }

    tinygltf::Model const& model_;
    std::map<int, TextureSlot> pictures_; // Pictures read so far, by the index of their texture.
};

// Reads the two numbers of the JSON array `name`; a missing number is replaced by `usual`.
Vec2f two_numbers(tinygltf::Value const& from, char const* name, float usual)
{
    auto const& list = from.Get(name);
    Vec2f pair = Vec2f::Constant(usual);
    for (int i = 0; i < 2; ++i)
        if (list.IsArray() && list.Get(i).IsNumber())
            pair[i] = static_cast<float>(std::clamp(list.Get(i).GetNumberAsDouble(), -1e4, 1e4));
    return pair;
}

} // namespace

// The rotation of KHR_texture_transform is counter-clockwise with v upwards. In glTF's texture
// coordinates, with v downwards, it is clockwise, as in Khronos' reference viewer.
Eigen::Affine2f texture_transform(tinygltf::Material const& material)
{
    auto const& surface = material.pbrMetallicRoughness;
    tinygltf::ExtensionMap const* extensions = nullptr;
    auto const take = [&](auto const& info) {
        if (!extensions && info.index >= 0)
            extensions = &info.extensions;
    };
    take(surface.baseColorTexture);
    take(surface.metallicRoughnessTexture);
    take(material.normalTexture);
    take(material.occlusionTexture);
    auto result = Eigen::Affine2f::Identity();
    if (!extensions)
        return result;
    auto const found = extensions->find("KHR_texture_transform");
    if (found == extensions->end() || !found->second.IsObject())
        return result;
    auto const& turn = found->second.Get("rotation");
    result.translate(two_numbers(found->second, "offset", 0));
    if (turn.IsNumber())
        result.rotate(Eigen::Rotation2Df(-static_cast<float>(
            std::remainder(std::clamp(turn.GetNumberAsDouble(), -1e6, 1e6), 2 * kPi))));
    result.scale(two_numbers(found->second, "scale", 1));
    return result;
}

std::vector<Material> read_materials(tinygltf::Model const& model)
{
    Reader reader(model);
    std::vector<Material> materials;
    for (auto const& material : model.materials)
        materials.push_back(reader.read(material));
    return materials;
}

} // namespace tractus::exports
