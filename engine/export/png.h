#pragma once

#include <cstddef>
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

// Makes a PNG file piece by piece: its rows in strips, which can be packed on several threads at
// once. The file is header(), then each strip from the top, then end().
class PngStrips {
public:
    // `channels` as in PngPicture.
    PngStrips(int width, int height, int channels);

    struct Strip {
        std::string chunk {};
        std::uint32_t sum = 1; // Checksum of the strip's rows (Adler-32).
        std::size_t bytes = 0; // Number of bytes that the sum is of.
    };
    // Packs whole rows. `above` is the row above them; empty for the first strip. Thread-safe.
    Strip pack(std::span<std::uint8_t const> rows, std::span<std::uint8_t const> above) const;

    std::string header() const;
    // Adds a strip's chunk to a file. Strips must come in order, all rows of the picture.
    void append(Strip const& strip, std::string& file);
    std::string end() const;

private:
    int width_;
    int height_;
    int channels_;
    std::uint32_t sum_ = 1;
};

} // namespace tractus::exports
