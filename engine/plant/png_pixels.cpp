#include "engine/plant/png_pixels.h"

#include "engine/base/check.h"

#include <algorithm>
#include <fmt/core.h>
#include <limits>
#include <memory>
#include <png.h>

namespace tractus {

Result<void> check_picture_size(std::int64_t width, std::int64_t height, std::int64_t most_pixels)
{
    constexpr std::int64_t kMillion = 1'000'000;
    if (width < 1 || height < 1)
        return fail(Fault::User, "the picture has no pixels");
    if (height <= most_pixels / width)
        return {};
    return fail(Fault::User,
                fmt::format("the picture has {} x {} pixels, more than {} million: make it smaller",
                            width, height, most_pixels / kMillion));
}

using PngImage = std::unique_ptr<png_image, void (*)(png_image*)>;

Result<void> read_png_pixels(std::string_view bytes, std::int64_t most_pixels,
                             PixelAllocator const& room)
{
    png_image png {};
    png.version = PNG_IMAGE_VERSION;
    PngImage const freed(&png, png_image_free);
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        return fail(Fault::User, fmt::format("the picture is damaged: {}", png.message));
    TRY(check_picture_size(png.width, png.height, most_pixels));
    png.format = PNG_FORMAT_RGBA;
    auto* const pixels = room(static_cast<int>(png.width), static_cast<int>(png.height));
    if (png_image_finish_read(&png, nullptr, pixels, 0, nullptr) == 0)
        return fail(Fault::User, fmt::format("the picture is damaged: {}", png.message));
    return {};
}

static bool is_opaque(std::vector<std::uint8_t> const& rgba)
{
    for (std::size_t i = 3; i < rgba.size(); i += 4)
        if (rgba[i] != 0xff)
            return false;
    return true;
}

static std::vector<std::uint8_t> without_alpha(std::vector<std::uint8_t> const& rgba)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        rgb.insert(rgb.end(), { rgba[i], rgba[i + 1], rgba[i + 2] });
    return rgb;
}

std::string upside_down_png(PixelRows const& rows)
{
    bool const has_alpha = !is_opaque(rows.rgba);
    auto const pixels = has_alpha ? rows.rgba : without_alpha(rows.rgba);
    png_image png {};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(rows.width);
    png.height = static_cast<png_uint_32>(rows.height);
    png.format = has_alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    png.flags = PNG_IMAGE_FLAG_FAST;
    PngImage const freed(&png, png_image_free);
    // A negative stride starts at the last row.
    auto const stride = -static_cast<png_int_32>(PNG_IMAGE_ROW_STRIDE(png));
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    bool const is_written
        = png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels.data(), stride, nullptr)
        != 0;
    CHECK(is_written);
    bytes.resize(size);
    return bytes;
}

} // namespace tractus
