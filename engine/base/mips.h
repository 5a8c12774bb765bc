#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus {

// A picture with 8 bits per channel. Rows run from the top; channels are interleaved.
struct PixelMap {
    int width = 0;
    int height = 0;
    int channels = 4;
    std::vector<std::uint8_t> pixels {};
};

// Type of a picture's content, which determines how pixels are averaged.
enum class MapKind {
    Color,  // Colours in sRGB, averaged in linear light; a fourth channel is alpha.
    Normal, // Normals as unit vectors, renormalised after averaging.
    Plain,
};

// Alpha of a picture at all mipmap levels. Each level is half as wide and high as the one before,
// rounded down, at least 1.
//
// A renderer that discards pixels with an alpha below one half would lose thin parts of a mask in
// small levels, and one that takes alpha as coverage would see too much of it if only the first
// were mended. Therefore each level keeps both: the share of pixels with an alpha of at least one
// half (Castaño, "Computing alpha mipmaps", 2010), to within half a pixel, and the mean alpha, as
// far as that share allows.
class AlphaMips {
public:
    // Makes levels until the longer side is at most `min_side` pixels. `alpha` has width * height
    // values; empty: an opaque picture.
    AlphaMips(std::span<std::uint8_t const> alpha, int width, int height, int min_side);

    struct Level {
        int width = 0;
        int height = 0;
        std::vector<float> mean {}; // Mean alpha of the full-size pixels below each pixel, 0 to 1.
        std::vector<std::uint8_t> shown {}; // Alpha that keeps the picture's coverage.
    };
    // Levels from the full size on.
    std::vector<Level> const& levels() const { return levels_; }

private:
    std::vector<Level> levels_;
};

// Returns the levels of a picture below its full size, largest first. Pixels count by their alpha,
// so that what lies outside the mask does not mix into it. Each level of a Color or Plain picture
// keeps the mean, in linear light for colours, of the pixels with an alpha of at least one half. A
// Color picture with four channels gets AlphaMips::Level::shown as its alpha.
std::vector<PixelMap> mip_levels(PixelMap const& picture, MapKind kind, AlphaMips const& alpha);

} // namespace tractus
