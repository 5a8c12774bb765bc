#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tractus::exports {

// A picture with 8 bits per channel. Rows run from the top, pixels from the left; channels are
// interleaved.
struct PngPicture {
    int width = 0;    // Width in pixels; at least 1.
    int height = 0;   // Height in pixels; at least 1.
    int channels = 1; // 1: grey; 3: red, green, blue; 4: with alpha, not premultiplied.
    std::span<std::uint8_t const> pixels {};

    // Fast takes a fraction of the time of Small and makes slightly larger files.
    enum class Packing { Small, Fast };
    Packing packing = Packing::Small;
};

// Returns the picture as a PNG file (ISO/IEC 15948). The same picture always gives the same bytes.
std::string png_bytes(PngPicture const& picture);

} // namespace tractus::exports
