#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tractus::exports {

// A picture of 8 bits per channel: rows from the top, pixels from the left, channels side by side.
struct PngPicture {
    int width = 0;    // 1 and more.
    int height = 0;   // 1 and more.
    int channels = 1; // 1: grey, 3: red, green, blue, 4: and alpha, not premultiplied.
    std::span<std::uint8_t const> pixels {};

    // Fast takes a small part of the time for some more bytes.
    enum class Packing { Small, Fast };
    Packing packing = Packing::Small;
};

// The picture as a PNG file (ISO/IEC 15948). Same picture, same bytes.
std::string png_bytes(PngPicture const& picture);

} // namespace tractus::exports
