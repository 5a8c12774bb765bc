#include "engine/lsystem/view/view_texture.h"

#include "engine/plant/png_pixels.h"

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr std::uint8_t kAlphaThreshold = 128;

// Converts an sRGB value to linear light (IEC 61966-2-1).
double light_of(double srgb)
{
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

double srgb_of(double light)
{
    return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// Returns the mean colour of a picture's visible pixels, as sRGB; grey if no pixel is visible.
Vec3f mean_of(PixelRows const& rows)
{
    std::array<double, 256> light {};
    for (std::size_t level = 0; level < light.size(); ++level)
        light[level] = light_of(static_cast<double>(level) / 255);
    Vec3 sum = Vec3::Zero();
    double count = 0;
    for (std::size_t i = 0; i < rows.rgba.size(); i += 4) {
        if (rows.rgba[i + 3] < kAlphaThreshold)
            continue;
        sum += Vec3(light[rows.rgba[i]], light[rows.rgba[i + 1]], light[rows.rgba[i + 2]]);
        ++count;
    }
    if (count == 0)
        return Vec3f::Constant(0.5f);
    return (sum / count).unaryExpr(&srgb_of).cast<float>();
}

bool has_holes(PixelRows const& rows)
{
    for (std::size_t i = 3; i < rows.rgba.size(); i += 4)
        if (rows.rgba[i] < kAlphaThreshold)
            return true;
    return false;
}

// Pictures repeat on stems, because stems are longer than their picture.
TexturePicture::Edges edges_of(Material::Kind kind)
{
    bool const is_tube = kind == Material::Kind::Bark || kind == Material::Kind::Stem;
    return is_tube ? TexturePicture::Edges::Repeat : TexturePicture::Edges::Clamp;
}

} // namespace

Result<void> put_texture(Material& material, std::string_view png)
{
    if (!png.starts_with("\x89PNG\r\n\x1a\n"))
        return fail(Fault::User, "it is no PNG picture: save it as one");
    if (png.size() > kMaxTextureBytes)
        return fail(
            Fault::User,
            fmt::format("it has more than {} MiB: make it smaller", kMaxTextureBytes >> 20));
    PixelRows rows;
    TRY(read_png_pixels(png, kMaxTexturePixels, [&](int width, int height) {
        rows.width = width;
        rows.height = height;
        rows.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        return rows.rgba.data();
    }));
    using Alpha = MaterialTextures::Alpha;
    material.base_color = mean_of(rows);
    material.textures.alpha = has_holes(rows) ? Alpha::Mask : Alpha::Opaque;
    material.textures.color = MaterialTextures::Color::Replaced;
    material.textures.base_color = std::make_shared<TexturePicture const>(
        TexturePicture { .bytes = upside_down_png(rows), .edges = edges_of(material.kind) });
    return {};
}

Result<void> read_texture(ViewReader& reader, Material& material, std::string const& name)
{
    auto const png = reader.file("texture", name, "the material has its colour alone");
    if (!png)
        return {};
    auto const put = put_texture(material, *png);
    if (!put)
        return reader.error(fmt::format("the texture {}: {}", name, put.error().message));
    return {};
}

} // namespace tractus::lsystem
