#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <vector>

namespace tractus::render {

// An sRGB colour, 0 to 255, with straight (not premultiplied) alpha.
struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    bool operator==(Color const&) const = default;
};

// Returns the colour with these components, 0 to 1. They are clamped and rounded.
Color color_from(Vec3f const& srgb);

// Converts an sRGB colour to linear light, 0 to 1. Uses the same approximation as the shaders, the
// power of 2.2.
Vec3f linear_light(Vec3f const& srgb);

// An image in memory. Rows go from top to bottom, pixels from left to right.
class Image {
public:
    Image() = default;
    Image(int width, int height, Color fill = {});

    int width() const { return width_; }
    int height() const { return height_; }

    Color& at(int x, int y) { return pixels_[index(x, y)]; }
    Color const& at(int x, int y) const { return pixels_[index(x, y)]; }

    // All pixels, row after row. Each has 4 bytes, red first.
    std::vector<Color>& pixels() { return pixels_; }
    std::vector<Color> const& pixels() const { return pixels_; }

    bool operator==(Image const&) const = default;

private:
    std::size_t index(int x, int y) const;

    int width_ = 0;
    int height_ = 0;
    std::vector<Color> pixels_;
};

// Copies `picture` into `onto`, with its upper left corner at (x, y). Parts outside `onto` are
// clipped.
void paste(Image& onto, Image const& picture, int x, int y);

// Returns the image upside down, for OpenGL, whose rows go from bottom to top.
Image flipped(Image const& picture);

// Returns the image in another size. Each pixel is the mean of the area that it covers in
// `picture`. This is meant for reducing: in an enlarged image, each old pixel becomes a block.
Image resized(Image const& picture, int width, int height);

// Writes a PNG file (ISO/IEC 15948) with 8 bits per channel: RGB if every pixel is opaque,
// otherwise RGBA. Fails with an internal error if the stream cannot be written or the image is
// empty.
Result<void> write_png(std::ostream& out, Image const& picture);

} // namespace tractus::render
