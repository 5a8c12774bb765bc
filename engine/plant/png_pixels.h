#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Fails with a user error if a picture has no pixels or more than `most_pixels`.
Result<void> check_picture_size(std::int64_t width, std::int64_t height, std::int64_t most_pixels);

// Allocates 4 bytes per pixel, aligned to 4 bytes; the memory must stay valid until
// read_png_pixels() returns.
using PixelAllocator = std::function<std::uint8_t*(int width, int height)>;

// Returns the PNG file without its texts (chunks iTXt, tEXt and zTXt). libpng would inflate each of
// them, up to 8 MB, only to discard it. If there are none, the result is a view of `png`; otherwise
// it is a view of `copy`.
std::string_view without_texts(std::string_view png, std::string& copy);

// Reads the pixels of a PNG file (ISO/IEC 15948) of any colour type and bit depth. They are stored
// in rows from the top, each as red, green, blue and alpha, not premultiplied; opaque if the file
// has no alpha. Safe for arbitrary bytes: claimed sizes are checked before memory is allocated.
// Fails with a user error, in a sentence without the file's name.
Result<void> read_png_pixels(std::string_view file, std::int64_t most_pixels,
                             PixelAllocator const& room);

// The pixels of a picture, as read by read_png_pixels().
struct PixelRows {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba {}; // Size 4 * width * height.
};

// Returns a PNG file of the pixels with the order of rows reversed. It has no alpha channel if all
// pixels are opaque. The same pixels always give the same bytes.
std::string upside_down_png(PixelRows const& rows);

} // namespace tractus
