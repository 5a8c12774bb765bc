#pragma once

#include "engine/base/result.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// Fails, as the user's fault, for a picture without pixels, or with more than that many.
Result<void> check_picture_size(std::int64_t width, std::int64_t height, std::int64_t most_pixels);

// Gives room for 4 bytes of each pixel, 4-byte aligned, as long as they are written.
using PixelRoom = std::function<std::uint8_t*(int width, int height)>;

// The pixels of a PNG file (ISO/IEC 15948) of any kind: rows from the top, red, green, blue, and
// alpha, not premultiplied; one without alpha is opaque. Any bytes are safe to give, and sizes that
// they claim are looked at before memory is taken. Fails, as the user's fault, in a sentence
// without the file's name.
Result<void> read_png_pixels(std::string_view bytes, std::int64_t most_pixels,
                             PixelRoom const& room);

// Such pixels.
struct PixelRows {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba {}; // 4 * width * height.
};

// A PNG file of the pixels, upside down: its first row is their last one. Without alpha where all
// are opaque. Same pixels, same bytes.
std::string upside_down_png(PixelRows const& rows);

} // namespace tractus
