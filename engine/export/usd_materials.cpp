#include "engine/export/usd_materials.h"

#include "engine/export/gltf_material.h"
#include "engine/export/texture.h"

#include <algorithm>
#include <string_view>

namespace tractus::exports {

namespace {

constexpr char const* kMaterialsScope = "Materials";

bool has_texture(auto const& textures, std::string_view name)
{
    return std::any_of(textures.begin(), textures.end(),
                       [&](auto const& texture) { return texture.name == name; });
}

// Returns a file name as a USD asset path, which is relative to the .usda file.
std::string asset_path(std::string const& name)
{
    return name.find('@') == std::string::npos ? fmt::format("@./{}@", name)
                                               : fmt::format("@@@./{}@@@", name);
}

} // namespace

UsdMaterials::UsdMaterials(std::string scope, std::string stem)
    : scope_(std::move(scope))
    , stem_(std::move(stem))
    , names_(usd_name, '_')
{
}

std::string UsdMaterials::path_of(Material const& material)
{
    auto const [name, is_new] = names_.name_of(material);
    if (is_new)
        materials_.emplace_back(name, material);
    return fmt::format("{}/{}/{}", scope_, kMaterialsScope, name);
}

void UsdMaterials::write(UsdText& text)
{
    text.begin("Scope", kMaterialsScope);
    for (auto const& [name, material] : materials_)
        write(text, name, material);
    text.end();
}

void UsdMaterials::write(UsdText& text, std::string const& name, Material const& material)
{
    auto const color = stem_.empty() ? std::string() : colored_picture(material);
    auto const textures = textures_to_write(material, color);
    text.begin("Material", name);
    text.line("token outputs:surface.connect = <{}/surface.outputs:surface>", text.path());
    write_surface(text, material, textures);
    if (!textures.empty()) {
        text.begin("Shader", "st");
        text.line("uniform token info:id = \"UsdPrimvarReader_float2\"");
        text.line("string inputs:varname = \"st\"");
        text.line("float2 outputs:result");
        text.end();
    }
    for (auto const& texture : textures)
        write_texture(text, name, texture);
    text.end();
}

std::vector<UsdMaterials::Texture> UsdMaterials::textures_to_write(Material const& material,
                                                                   std::string const& color) const
{
    std::vector<Texture> found;
    if (stem_.empty())
        return found;
    // The pictures outlive this function: they belong to the material, or to its kind.
    auto const textures = textures_of(material);
    if (!color.empty()) {
        bool const is_own = material.textures.base_color != nullptr;
        found.push_back(
            { .name = "color",
              .bytes = color,
              .edges = textures.base_color ? textures.base_color->edges : TexturePicture::Edges(),
              .is_color = true,
              .scale = is_own ? multiplied_color(material) : Vec3::Ones() });
    }
    auto const add
        = [&](char const* name, TextureSlot const& slot, Vec3 const& scale, Vec3 const& bias) {
              if (slot)
                  found.push_back({ name, slot->bytes, slot->edges, false, scale, bias });
          };
    auto const slope = double { textures.normal_strength };
    auto const shade = double { textures.occlusion_strength };
    add("normal", textures.normal, { 2 * slope, 2 * slope, 2 }, { -slope, -slope, -1 });
    add("occlusion", textures.occlusion, Vec3::Constant(shade), Vec3::Constant(1 - shade));
    add("roughness", textures.roughness,
        { 1, double { material.roughness }, double { material.metalness } }, Vec3::Zero());
    return found;
}

void UsdMaterials::write_surface(UsdText& text, Material const& material,
                                 std::vector<Texture> const& textures) const
{
    auto const material_path = text.path();
    text.begin("Shader", "surface");
    text.line("uniform token info:id = \"UsdPreviewSurface\"");
    auto const connect = [&](char const* input, char const* texture, char const* channel) {
        bool const has = has_texture(textures, texture);
        if (has)
            text.line("{}.connect = <{}/{}.outputs:{}>", input, material_path, texture, channel);
        return has;
    };
    if (!connect("color3f inputs:diffuseColor", "color", "rgb")) {
        Vec3 const color = linear_color(material.base_color);
        text.line("color3f inputs:diffuseColor = ({:.6g}, {:.6g}, {:.6g})", color.x(), color.y(),
                  color.z());
    }
    if (!connect("float inputs:roughness", "roughness", "g"))
        text.line("float inputs:roughness = {:.6g}", std::clamp(material.roughness, 0.0f, 1.0f));
    if (!connect("float inputs:metallic", "roughness", "b"))
        text.line("float inputs:metallic = {:.6g}", std::clamp(material.metalness, 0.0f, 1.0f));
    if (material.textures.alpha == MaterialTextures::Alpha::Mask
        && connect("float inputs:opacity", "color", "a"))
        text.line("float inputs:opacityThreshold = 0.5");
    connect("normal3f inputs:normal", "normal", "rgb");
    connect("float inputs:occlusion", "occlusion", "r");
    text.line("token outputs:surface");
    text.end();
}

void UsdMaterials::write_texture(UsdText& text, std::string const& material, Texture const& texture)
{
    auto const st = fmt::format("<{}/st.outputs:result>", text.path());
    auto const* const wrap = texture.edges == TexturePicture::Edges::Repeat ? "repeat" : "clamp";
    text.begin("Shader", texture.name);
    text.line("uniform token info:id = \"UsdUVTexture\"");
    text.line("asset inputs:file = {}", asset_path(file_of(material, texture)));
    text.line("token inputs:sourceColorSpace = \"{}\"", texture.is_color ? "sRGB" : "raw");
    text.line("token inputs:wrapS = \"{}\"", wrap);
    text.line("token inputs:wrapT = \"{}\"", wrap);
    auto const& [scale, bias] = std::pair(texture.scale, texture.bias);
    if (scale != Vec3::Ones())
        text.line("float4 inputs:scale = ({:.6g}, {:.6g}, {:.6g}, 1)", scale.x(), scale.y(),
                  scale.z());
    if (bias != Vec3::Zero())
        text.line("float4 inputs:bias = ({:.6g}, {:.6g}, {:.6g}, 0)", bias.x(), bias.y(), bias.z());
    text.line("float2 inputs:st.connect = {}", st);
    text.line("float3 outputs:rgb");
    for (char const channel : { 'r', 'g', 'b', 'a' })
        text.line("float outputs:{}", channel);
    text.end();
}

// Returns the name of the picture's file, which is added to pictures_ when it is first used.
std::string UsdMaterials::file_of(std::string const& material, Texture const& texture)
{
    auto const [place, is_new] = files_.emplace(texture.bytes, "");
    if (is_new) {
        bool const is_jpeg = texture.bytes.starts_with("\xff\xd8");
        place->second
            = fmt::format("{}-{}-{}.{}", stem_, material, texture.name, is_jpeg ? "jpg" : "png");
        pictures_.push_back({ place->second, texture.bytes });
    }
    return place->second;
}

} // namespace tractus::exports
