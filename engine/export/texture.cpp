#include "engine/export/texture.h"

#include "engine/base/check.h"
#include "engine/base/vectors.h"
#include "engine/export/bark_relief.h"
#include "engine/export/gltf_material.h"
#include "engine/export/png.h"
#include "engine/plant/png_pixels.h"

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

MaterialTextures textures_of(Material const& material, int bark_px)
{
    static auto const bark = slot_of(bark_picture(), TexturePicture::Edges::Repeat);
    static auto const leaf = slot_of(leaf_picture(), TexturePicture::Edges::Clamp);
    auto textures = material.textures;
    if (material.kind == Material::Kind::Leaf && !textures.base_color)
        textures.base_color = leaf;
    if (material.kind != Material::Kind::Bark)
        return textures;
    bool const is_furrowed = material.bark.kind == BarkKind::Furrowed;
    auto const made = is_furrowed ? BarkPictures { bark, bark_normals(), bark_occlusion() }
                                  : bark_pictures(material.bark, bark_px);
    if (!textures.base_color)
        textures.base_color = made.color;
    if (!textures.normal)
        textures.normal = made.normals;
    if (!textures.occlusion)
        textures.occlusion = made.occlusion_roughness;
    if (!textures.roughness)
        textures.roughness = made.occlusion_roughness;
    return textures;
}

void prepare_bark(mesh::Mesh const& mesh)
{
    for (auto const& surface : mesh.surfaces) {
        auto const& material = mesh.materials.at(surface.material);
        if (material.kind == Material::Kind::Bark && material.bark.kind != BarkKind::Furrowed)
            bark_pictures(material.bark);
    }
}

// Returns the mean linear lightness of a picture: 0 for black, 1 for white.
static double mean_light(GreyPicture const& picture)
{
    double sum = 0;
    for (auto const level : picture.pixels)
        sum += linear_from_srgb(static_cast<double>(level) / 255);
    return sum / static_cast<double>(picture.pixels.size());
}

Vec3 multiplied_color(Material const& material, int bark_px)
{
    auto const& textures = material.textures;
    if (textures.base_color && textures.color == MaterialTextures::Color::Replaced)
        return Vec3::Ones();
    Vec3 const own = linear_color(material.base_color);
    bool const is_bark = material.kind == Material::Kind::Bark;
    if (textures.base_color || (!is_bark && material.kind != Material::Kind::Leaf))
        return own;
    if (is_bark && material.bark.kind != BarkKind::Furrowed) {
        Vec3 const factor = own.cwiseQuotient(bark_pictures(material.bark, bark_px).mean_color);
        return factor / std::max(factor.maxCoeff(), 1.0);
    }
    static double const bark = mean_light(bark_picture());
    static double const leaf = mean_light(leaf_picture());
    return own * std::min(1 / (is_bark ? bark : leaf), 1 / std::max(own.maxCoeff(), 1e-6));
}

bool has_relief(Material const& material)
{
    return material.kind == Material::Kind::Bark || material.textures.normal;
}

// For each channel, the sRGB levels of a picture after multiplication by a colour. Linear light is
// multiplied, not sRGB values, so that colours agree with those in .glb files.
using ChannelLevels = std::array<std::array<std::uint8_t, 256>, 3>;

static ChannelLevels multiplied_levels(Vec3 const& color)
{
    ChannelLevels levels {};
    for (std::size_t k = 0; k < levels.size(); ++k)
        for (std::size_t level = 0; level < levels[k].size(); ++level) {
            double const light = color[static_cast<Eigen::Index>(k)]
                * linear_from_srgb(static_cast<double>(level) / 255);
            levels[k][level]
                = static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(light)));
        }
    return levels;
}

// Returns one of our own opaque pictures with its levels replaced.
static std::string shaded_picture(TexturePicture const& picture, ChannelLevels const& levels)
{
    PixelRows rows;
    auto const read = read_png_pixels(
        picture.bytes, kMaxBarkPicture_px * kMaxBarkPicture_px, [&](int w, int h) {
            rows = { w, h,
                     std::vector<std::uint8_t>(std::size_t { 4 } * static_cast<std::size_t>(w)
                                               * static_cast<std::size_t>(h)) };
            return rows.rgba.data();
        });
    CHECK(read.has_value());
    std::vector<std::uint8_t> pixels;
    pixels.reserve(rows.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rows.rgba.size(); i += 4)
        for (std::size_t k = 0; k < levels.size(); ++k)
            pixels.push_back(levels[k][rows.rgba[i + k]]);
    return png_bytes({ rows.width, rows.height, 3, pixels, PngPicture::Packing::Fast });
}

std::string colored_picture(Material const& material)
{
    if (material.textures.base_color)
        return material.textures.base_color->bytes;
    bool const is_bark = material.kind == Material::Kind::Bark;
    if (!is_bark && material.kind != Material::Kind::Leaf)
        return {};
    auto const shades = multiplied_levels(multiplied_color(material));
    if (is_bark && material.bark.kind != BarkKind::Furrowed)
        return shaded_picture(*bark_pictures(material.bark).color, shades);
    auto const grey = is_bark ? bark_picture() : leaf_picture();
    std::vector<std::uint8_t> pixels;
    pixels.reserve(3 * grey.pixels.size());
    for (auto const level : grey.pixels)
        for (auto const& channel : shades)
            pixels.push_back(channel[level]);
    return png_bytes({ grey.width, grey.height, 3, pixels });
}

std::string png_bytes(GreyPicture const& picture)
{
    return png_bytes(
        { picture.width, picture.height, 1, picture.pixels, PngPicture::Packing::Fast });
}

} // namespace tractus::exports
