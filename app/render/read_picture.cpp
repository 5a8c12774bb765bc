#include "app/render/read_picture.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fmt/core.h>
#include <libexif/exif-data.h>
#include <limits>
#include <memory>
#include <utility>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

namespace tractus {

namespace {

// How the rows and columns of a JPEG lie, as the camera that took it says: 1 to 8 (Exif 2.32,
// section 4.6.4, "Orientation"). 1, the upright one, where it says nothing.
int orientation_of(std::string_view bytes)
{
    std::unique_ptr<ExifData, void (*)(ExifData*)> const data(
        exif_data_new_from_data(reinterpret_cast<unsigned char const*>(bytes.data()),
                                static_cast<unsigned>(bytes.size())),
        exif_data_unref);
    auto const* const entry
        = data ? exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION) : nullptr;
    if (!entry || entry->format != EXIF_FORMAT_SHORT || entry->components < 1)
        return 1;
    int const orientation = exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
    return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

// Orientations 5 to 8 have columns for rows; of each four, the second and the third are mirrored
// from left to right, the third and the fourth from top to bottom, as the eye sees them.
Image upright(Image picture, int orientation)
{
    if (orientation == 1)
        return picture;
    bool const is_turned = orientation >= 5;
    bool const is_mirrored
        = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    bool const is_upside_down
        = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    Image turned(is_turned ? picture.height() : picture.width(),
                 is_turned ? picture.width() : picture.height());
    for (int y = 0; y < turned.height(); ++y)
        for (int x = 0; x < turned.width(); ++x) {
            int const across = is_mirrored ? turned.width() - 1 - x : x;
            int const down = is_upside_down ? turned.height() - 1 - y : y;
            turned.at(x, y) = is_turned ? picture.at(down, across) : picture.at(across, down);
        }
    return turned;
}

} // namespace

Result<Image> read_picture(std::string_view bytes)
{
    constexpr std::int64_t kMostPixels = 100'000'000;
    if (bytes.size() > std::numeric_limits<int>::max())
        return fail(Fault::User, "the picture is larger than 2 GiB");
    auto const* const data = reinterpret_cast<stbi_uc const*>(bytes.data());
    auto const size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
        return fail(Fault::User, "it is neither a PNG nor a JPEG picture");
    if (std::int64_t { width } * height > kMostPixels)
        return fail(Fault::User,
                    fmt::format("the picture has {} x {} pixels, more than 100 million: make it "
                                "smaller",
                                width, height));
    std::unique_ptr<stbi_uc, void (*)(void*)> const pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, STBI_rgb_alpha), std::free);
    if (!pixels)
        return fail(Fault::User, fmt::format("the picture is damaged: {}", stbi_failure_reason()));
    Image image(width, height);
    static_assert(sizeof(Color) == STBI_rgb_alpha);
    std::memcpy(image.pixels().data(), pixels.get(), image.pixels().size() * sizeof(Color));
    return upright(std::move(image), orientation_of(bytes));
}

} // namespace tractus
