#include "engine/export/texture.h"

#include "engine/base/vectors.h"
#include "engine/export/bark_relief.h"
#include "engine/export/gltf_material.h"
#include "engine/export/png.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::exports {
namespace {

constexpr int kSize = 256;

double eased(double low, double high, double x)
{
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double leaf_level(double u, double v)
{
    // Distance from the midrib: 0 at the midrib, 1 at the margin.
    double const side = std::abs(u - 0.5) * 2;
    double const midrib = 1 - eased(0.02, 0.05 + 0.02 * (1 - v), side);
    // Lateral veins leave the midrib at regular intervals and curve towards the tip.
    constexpr double kVeins = 9;
    double const along = kVeins * (v - 0.32 * side + 0.06 * side * side) + 0.5;
    double const from_vein = std::abs(along - std::floor(along) - 0.5);
    double const vein = (1 - eased(0.04, 0.12, from_vein)) * (1 - 0.6 * side);
    double const between = 0.05 * eased(0.1, 0.5, from_vein);
    return 0.82 + 0.16 * std::max(midrib, 0.8 * vein) - between;
}

template<typename Level> GreyPicture paint(Level const& level)
{
    GreyPicture picture { kSize, kSize, {} };
    picture.pixels.reserve(std::size_t { kSize } * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            double const grey = level((x + 0.5) / kSize, (y + 0.5) / kSize);
            picture.pixels.push_back(
                static_cast<std::uint8_t>(std::lround(255 * std::clamp(grey, 0.0, 1.0))));
        }
    return picture;
}

} // namespace

GreyPicture bark_picture()
{
    return bark_color_picture();
}

GreyPicture leaf_picture()
{
    return paint(leaf_level);
}

static TextureSlot slot_of(GreyPicture const& picture, TexturePicture::Edges edges)
{
    return std::make_shared<TexturePicture const>(TexturePicture { png_bytes(picture), edges });
}

MaterialTextures textures_of(Material const& material)
{
    static auto const bark = slot_of(bark_picture(), TexturePicture::Edges::Repeat);
    static auto const leaf = slot_of(leaf_picture(), TexturePicture::Edges::Clamp);
    auto textures = material.textures;
    if (material.kind == Material::Kind::Leaf && !textures.base_color)
        textures.base_color = leaf;
    if (material.kind != Material::Kind::Bark)
        return textures;
    if (!textures.base_color)
        textures.base_color = bark;
    if (!textures.normal)
        textures.normal = bark_normals();
    if (!textures.occlusion)
        textures.occlusion = bark_occlusion();
    if (!textures.roughness)
        textures.roughness = bark_occlusion();
    return textures;
}

// Returns the mean linear lightness of a picture: 0 for black, 1 for white.
static double mean_light(GreyPicture const& picture)
{
    double sum = 0;
    for (auto const level : picture.pixels)
        sum += linear_from_srgb(static_cast<double>(level) / 255);
    return sum / static_cast<double>(picture.pixels.size());
}

Vec3 multiplied_color(Material const& material)
{
    auto const& textures = material.textures;
    if (textures.base_color && textures.color == MaterialTextures::Color::Replaced)
        return Vec3::Ones();
    Vec3 const own = linear_color(material.base_color);
    bool const is_bark = material.kind == Material::Kind::Bark;
    if (textures.base_color || (!is_bark && material.kind != Material::Kind::Leaf))
        return own;
    static double const bark = mean_light(bark_picture());
    static double const leaf = mean_light(leaf_picture());
    return own * std::min(1 / (is_bark ? bark : leaf), 1 / std::max(own.maxCoeff(), 1e-6));
}

bool has_relief(Material const& material)
{
    return material.kind == Material::Kind::Bark || material.textures.normal;
}

std::string colored_picture(Material const& material)
{
    if (material.textures.base_color)
        return material.textures.base_color->bytes;
    bool const is_bark = material.kind == Material::Kind::Bark;
    if (!is_bark && material.kind != Material::Kind::Leaf)
        return {};
    auto const grey = is_bark ? bark_picture() : leaf_picture();
    // Linear light is multiplied, not sRGB values, so that colours agree with those in .glb files.
    Vec3 const color = multiplied_color(material);
    std::array<std::array<std::uint8_t, 3>, 256> shades {};
    for (std::size_t level = 0; level < shades.size(); ++level)
        for (int k = 0; k < 3; ++k) {
            double const light = color[k] * linear_from_srgb(static_cast<double>(level) / 255);
            shades[level][static_cast<std::size_t>(k)]
                = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(light)));
        }
    std::vector<std::uint8_t> pixels;
    pixels.reserve(3 * grey.pixels.size());
    for (auto const level : grey.pixels)
        pixels.insert(pixels.end(), shades[level].begin(), shades[level].end());
    return png_bytes({ grey.width, grey.height, 3, pixels });
}

std::string png_bytes(GreyPicture const& picture)
{
    return png_bytes(
        { picture.width, picture.height, 1, picture.pixels, PngPicture::Packing::Fast });
}

} // namespace tractus::exports
