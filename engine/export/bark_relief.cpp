#include "engine/export/bark_relief.h"

#include "engine/base/random.h"
#include "engine/base/vectors.h"
#include "engine/export/png.h"
#include "engine/export/relief_tile.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace tractus::exports {
namespace {

constexpr int kRelief_px = 512;
constexpr std::uint32_t kReliefStream = 0x72656c69;

double eased_between(double low, double high, double x)
{
    double const t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// Value noise around a cylinder of radius 1, periodic along its axis.
class CylinderNoise {
public:
    // `across`: number of cells per radius of the cylinder; `along`: number of cells per period.
    CylinderNoise(std::uint32_t layer, double across, int along)
        : across_(across)
        , along_(along)
        , side_(2 * static_cast<int>(std::ceil(across)) + 3)
    {
        auto const count
            = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_ * along);
        values_.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            values_.push_back(
                random_block({ .seed = 0, .stream = kReliefStream, .substream = layer }, i)[0]
                * 0x1p-32);
    }

    // Returns the noise at a point, 0 to 1. `x` and `y`: -1 to 1, across the axis; `v`: position
    // along the axis, in periods; `shift`: offset along the axis, in cells.
    double at(double x, double y, double v, double shift = 0) const
    {
        double const middle = 0.5 * side_;
        double const place[3] = { middle + x * across_, middle + y * across_, v * along_ + shift };
        int cell[3];
        double part[3];
        for (int k = 0; k < 3; ++k) {
            cell[k] = static_cast<int>(std::floor(place[k]));
            part[k] = eased_between(0, 1, place[k] - cell[k]);
        }
        double sum = 0;
        for (int corner = 0; corner < 8; ++corner) {
            double weight = 1;
            for (int k = 0; k < 3; ++k)
                weight *= (corner >> k & 1) ? part[k] : 1 - part[k];
            sum += weight
                * value(cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                        cell[2] + (corner >> 2));
        }
        return sum;
    }

private:
    double value(int x, int y, int z) const
    {
        z = (z % along_ + along_) % along_;
        return values_[static_cast<std::size_t>(
            std::clamp(x, 0, side_ - 1) + side_ * (std::clamp(y, 0, side_ - 1) + side_ * z))];
    }

    double across_;
    int along_;
    int side_;
    std::vector<double> values_;
};

// Height field of ridges between furrows, like that of the renderer's shader (surface.cpp). It has
// a whole number of cells along the axis, so that it can be tiled.
ReliefTile furrowed_relief()
{
    CylinderNoise const wander(0, 2, 7);
    CylinderNoise const coarse(1, 3.4, 5);
    CylinderNoise const fine(2, 8, 15);
    std::vector<double> heights;
    for (int row = 0; row < kRelief_px; ++row)
        for (int column = 0; column < kRelief_px; ++column) {
            double const angle = 2 * kPi * (column + 0.5) / kRelief_px;
            double const v = (row + 0.5) / kRelief_px;
            double const x = std::cos(angle);
            double const y = std::sin(angle);
            double const bent = wander.at(x, y, v);
            double const large = 1 - std::abs(2 * coarse.at(x, y, v, 0.8 * bent) - 1);
            double const small = 1 - std::abs(2 * fine.at(x, y, v, bent) - 1);
            heights.push_back(0.68 * large + 0.32 * small);
        }
    return { kRelief_px, std::move(heights) };
}

ReliefTile const& relief()
{
    static ReliefTile const relief = furrowed_relief();
    return relief;
}

std::uint8_t byte_of(double value)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

// Makes a picture pixel by pixel. color(column, row) returns a pixel's red, green and blue, 0 to 1.
template<typename Color> TextureSlot paint_colors(Color const& color)
{
    std::vector<std::uint8_t> pixels;
    pixels.reserve(std::size_t { 3 } * kRelief_px * kRelief_px);
    for (int row = 0; row < kRelief_px; ++row)
        for (int column = 0; column < kRelief_px; ++column)
            for (double const value : Vec3(color(column, row)))
                pixels.push_back(byte_of(value));
    return std::make_shared<TexturePicture const>(TexturePicture {
        png_bytes({ kRelief_px, kRelief_px, 3, pixels, PngPicture::Packing::Fast }),
        TexturePicture::Edges::Repeat });
}

Vec3 normal_color(int column, int row)
{
    // Depth of the relief as a share of the branch's circumference, as in the renderer's shader.
    constexpr double kBump = 0.055;
    return relief().normal(column, row, kBump);
}

Vec3 occlusion_color(int column, int row)
{
    return { relief().openness(column, row), 1, 0 };
}

} // namespace

GreyPicture bark_color_picture()
{
    GreyPicture picture { kRelief_px, kRelief_px, {} };
    for (int row = 0; row < kRelief_px; ++row)
        for (int column = 0; column < kRelief_px; ++column)
            picture.pixels.push_back(
                byte_of(0.45 + 0.55 * eased_between(0.30, 0.95, relief().at(column, row))));
    return picture;
}

TextureSlot bark_normals()
{
    static auto const normals = paint_colors(normal_color);
    return normals;
}

TextureSlot bark_occlusion()
{
    static auto const occlusion = paint_colors(occlusion_color);
    return occlusion;
}

} // namespace tractus::exports
