#include "engine/plant/png_pixels.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <limits>
#include <memory>
#include <png.h>
#include <zlib.h>

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

// Plausible minimum and maximum number of bytes in the inflated rows of a PNG file. The maximum
// allows for interlaced rows and for superfluous bytes that some programs write after the rows.
struct RowBytes {
    std::uint64_t least = 0;
    std::uint64_t most = 0;
};

static RowBytes row_bytes(std::string_view png, std::uint64_t width, std::uint64_t height)
{
    // Channels per pixel, by colour type.
    constexpr std::array<std::uint64_t, 7> kChannels { 1, 1, 3, 1, 2, 1, 4 };
    auto const depth = static_cast<unsigned char>(png[24]);
    auto const type = static_cast<unsigned char>(png[25]);
    auto const bits = depth * (type < kChannels.size() ? kChannels[type] : 4);
    auto const least = (width * height * bits + 7) / 8;
    return { least, 2 * least + 16 * height + 65536 };
}

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kAroundData = 12; // Bytes of a chunk's length, type and checksum.

// Returns the chunk that begins at `at`, with its length, type and checksum; it is cut off where
// the file ends. Requires `at` <= size of the file - kAroundData.
static std::string_view chunk_at(std::string_view png, std::size_t at)
{
    auto const size = png_get_uint_32(reinterpret_cast<png_const_bytep>(png.data()) + at);
    return png.substr(at, std::min<std::size_t>(size, png.size() - at - kAroundData) + kAroundData);
}

static std::string_view type_of(std::string_view chunk)
{
    return chunk.substr(4, 4);
}

std::string_view without_texts(std::string_view png, std::string& copy)
{
    auto const is_text = [](std::string_view chunk) {
        auto const type = type_of(chunk);
        return type == "iTXt" || type == "tEXt" || type == "zTXt";
    };
    std::size_t kept_to = 0; // End of what was copied or left out.
    for (auto at = kSignatureBytes; at + kAroundData <= png.size();) {
        auto const chunk = chunk_at(png, at);
        if (is_text(chunk)) {
            copy += png.substr(kept_to, at - kept_to);
            kept_to = at + chunk.size();
        }
        at += chunk.size();
    }
    if (kept_to == 0)
        return png;
    copy += png.substr(kept_to);
    return copy;
}

// Inflates the image data (the IDAT chunks) without keeping it, and returns the number of bytes.
// Stops as soon as the number exceeds `most`.
static std::uint64_t inflated_bytes(std::string_view png, std::uint64_t most)
{
    z_stream stream {};
    if (inflateInit(&stream) != Z_OK)
        return 0;
    std::unique_ptr<z_stream, int (*)(z_stream*)> const ended(&stream, inflateEnd);
    std::array<unsigned char, 65536> piece;
    std::uint64_t count = 0;
    int result = Z_OK;
    for (auto at = kSignatureBytes;
         result == Z_OK && count <= most && at + kAroundData <= png.size();) {
        auto const chunk = chunk_at(png, at);
        at += chunk.size();
        if (type_of(chunk) != "IDAT")
            continue;
        // zlib does not change its input.
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(chunk.data() + 8));
        stream.avail_in = static_cast<uInt>(chunk.size() - kAroundData);
        do {
            stream.next_out = piece.data();
            stream.avail_out = static_cast<uInt>(piece.size());
            result = inflate(&stream, Z_NO_FLUSH);
            count += piece.size() - stream.avail_out;
        } while (result == Z_OK && stream.avail_out == 0 && count <= most);
        // Z_BUF_ERROR only means that zlib needs the next chunk.
        result = result == Z_BUF_ERROR ? Z_OK : result;
    }
    return count;
}

// Fails if the file holds fewer pixels than it claims, since memory would be allocated for the
// claimed ones, or far more data, since libpng would inflate all of it.
static Result<void> check_data(std::string_view png, std::uint64_t width, std::uint64_t height)
{
    auto const [least, most] = row_bytes(png, width, height);
    auto const count = inflated_bytes(png, most);
    if (count >= least && count <= most)
        return {};
    return fail(Fault::User,
                fmt::format("the picture is damaged: it holds {} than its {} x {} pixels: save it "
                            "again",
                            count < least ? "less" : "far more", width, height));
}

using PngImage = std::unique_ptr<png_image, void (*)(png_image*)>;

Result<void> read_png_pixels(std::string_view file, std::int64_t most_pixels,
                             PixelAllocator const& room)
{
    std::string copy;
    auto const bytes = without_texts(file, copy);
    png_image png {};
    png.version = PNG_IMAGE_VERSION;
    PngImage const freed(&png, png_image_free);
    if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0)
        return fail(Fault::User, fmt::format("the picture is damaged: {}", png.message));
    TRY(check_picture_size(png.width, png.height, most_pixels));
    TRY(check_data(bytes, png.width, png.height));
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
    // With a negative stride libpng starts at the last row.
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
