#include "engine/export/texture.h"

#include "engine/base/random.h"
#include "engine/base/vectors.h"
#include "engine/export/png.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus {
namespace {

constexpr int kSize = 256;

// What the random numbers here are for.
constexpr std::uint32_t kBarkStream = 0x6261726b;

double smooth_step(double low, double high, double x)
{
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Value noise on a grid of `columns` by `rows` cells that repeats at the picture's edges.
// `u` and `v` are 0 to 1; the answer is too.
double tiling_noise(std::uint32_t layer, int columns, int rows, double u, double v)
{
    auto const value = [&](int column, int row) {
        auto const cell = static_cast<std::uint64_t>((row % rows) * columns + column % columns);
        return random_block({ .seed = 0, .stream = kBarkStream, .substream = layer }, cell)[0]
            * 0x1p-32;
    };
    double const x = u * columns;
    double const y = v * rows;
    auto const column = static_cast<int>(x);
    auto const row = static_cast<int>(y);
    double const a = smooth_step(0, 1, x - column);
    double const b = smooth_step(0, 1, y - row);
    return (1 - b) * ((1 - a) * value(column, row) + a * value(column + 1, row))
        + b * ((1 - a) * value(column, row + 1) + a * value(column + 1, row + 1));
}

double bark_level(double u, double v)
{
    // Furrows wander sideways, so the ridges between them join and part.
    double const wander
        = 0.05 * (tiling_noise(0, 6, 5, u, v) - 0.5) + 0.02 * (tiling_noise(1, 16, 12, u, v) - 0.5);
    double const across = u + wander + 1;
    double const place = across - std::floor(across);
    double const coarse = tiling_noise(2, 22, 5, place, v);
    double const fine = tiling_noise(3, 64, 20, place, v);
    double const grain = tiling_noise(4, 128, 96, u, v);
    double const ridge = smooth_step(0.15, 0.7, 0.6 * coarse + 0.4 * fine);
    return 0.5 + 0.43 * ridge + 0.07 * grain;
}

double leaf_level(double u, double v)
{
    double const side = std::abs(u - 0.5) * 2; // 0 at the midrib, 1 at the margin.
    double const midrib = 1 - smooth_step(0.02, 0.05 + 0.02 * (1 - v), side);
    // Veins leave the midrib at equal distances and climb towards the margin.
    constexpr double kVeins = 9;
    double const along = kVeins * (v - 0.32 * side + 0.06 * side * side) + 0.5;
    double const from_vein = std::abs(along - std::floor(along) - 0.5);
    double const vein = (1 - smooth_step(0.04, 0.12, from_vein)) * (1 - 0.6 * side);
    double const between = 0.05 * smooth_step(0.1, 0.5, from_vein);
    return 0.82 + 0.16 * std::max(midrib, 0.8 * vein) - between;
}

template<typename Level> GreyPicture paint(Level const& level)
{
    GreyPicture picture { kSize, kSize, {} };
    picture.pixels.reserve(std::size_t { kSize } * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            double const grey = level((x + 0.5) / kSize, (y + 0.5) / kSize);
            picture.pixels.push_back(
                static_cast<std::uint8_t>(std::lround(255 * std::clamp(grey, 0.0, 1.0))));
        }
    return picture;
}

} // namespace

GreyPicture bark_picture()
{
    return paint(bark_level);
}

GreyPicture leaf_picture()
{
    return paint(leaf_level);
}

std::string png_bytes(GreyPicture const& picture)
{
    return png_bytes({ picture.width, picture.height, 1, picture.pixels });
}

} // namespace tractus
