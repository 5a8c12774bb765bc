#include "app/render/read_picture.h"

#include "engine/plant/png_pixels.h"

#include <cstdint>
#include <fmt/core.h>
#include <libexif/exif-data.h>
#include <limits>
#include <memory>
#include <string>
#include <turbojpeg.h>
#include <utility>

namespace tractus::render {

namespace {

// Returns the orientation that the camera stored in a JPEG, 1 to 8 (Exif 2.32, section 4.6.4,
// "Orientation"). Returns 1, upright, if there is no valid one.
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

// Turns an image upright. For orientations 5 to 8, rows and columns are swapped. For 2, 3, 6 and 7,
// the stored image is mirrored horizontally; for 3, 4, 7 and 8, vertically.
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

// Both libraries, for PNG and for JPEG, write pixels of this layout.
static_assert(sizeof(Color) == 4);

constexpr std::int64_t kMaxPixels = 100'000'000;

auto fail_damaged(std::string const& why)
{
    return fail(Fault::User, fmt::format("the picture is damaged: {}", why));
}

Result<Image> read_png(std::string_view bytes)
{
    Image image;
    TRY(read_png_pixels(bytes, kMaxPixels, [&](int width, int height) {
        image = Image(width, height);
        return reinterpret_cast<std::uint8_t*>(image.pixels().data());
    }));
    return image;
}

// Fails if the file is too short for the size that it claims, for which much memory would be
// allocated. Each block of 8 x 8 pixels takes at least one bit; in pictures, it takes dozens.
Result<void> check_jpeg_data(std::size_t bytes, std::int64_t width, std::int64_t height)
{
    constexpr std::int64_t kMaxPixelsPerByte = 8 * 64;
    // Smaller pictures take little memory, and their truncated files show what is left.
    constexpr std::int64_t kAlwaysRead = 4'000'000;
    if (width * height <= kAlwaysRead
        || static_cast<std::int64_t>(bytes) >= width * height / kMaxPixelsPerByte)
        return {};
    return fail_damaged(
        fmt::format("it holds less than its {} x {} pixels: save it again", width, height));
}

// Decodes a JPEG. Warnings of the library are ignored, as the files of many cameras and programs
// cause them, for example by stray bytes between segments.
Result<Image> read_jpeg(std::string_view bytes)
{
    std::unique_ptr<void, int (*)(void*)> const decoder(tjInitDecompress(), tjDestroy);
    auto const* const data = reinterpret_cast<unsigned char const*>(bytes.data());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colors = 0;
    if (tjDecompressHeader3(decoder.get(), data, bytes.size(), &width, &height, &subsampling,
                            &colors)
        != 0)
        return fail_damaged(tjGetErrorStr2(decoder.get()));
    TRY(check_picture_size(width, height, kMaxPixels));
    TRY(check_jpeg_data(bytes.size(), width, height));
    Image image(width, height);
    auto* const pixels = reinterpret_cast<unsigned char*>(image.pixels().data());
    if (tjDecompress2(decoder.get(), data, bytes.size(), pixels, width, 0, height, TJPF_RGBA,
                      TJFLAG_LIMITSCANS)
            != 0
        && tjGetErrorCode(decoder.get()) != TJERR_WARNING)
        return fail_damaged(tjGetErrorStr2(decoder.get()));
    return image;
}

} // namespace

Result<Image> read_picture(std::string_view bytes)
{
    if (bytes.size() > std::numeric_limits<int>::max())
        return fail(Fault::User, "the picture is larger than 2 GiB");
    if (bytes.starts_with("\x89PNG"))
        return read_png(bytes);
    if (!bytes.starts_with("\xff\xd8"))
        return fail(Fault::User, "it is neither a PNG nor a JPEG picture");
    return upright(TRY(read_jpeg(bytes)), orientation_of(bytes));
}

} // namespace tractus::render
