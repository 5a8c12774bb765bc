#include "app/render/image.h"

#include "engine/base/check.h"
#include "engine/export/png.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <string>

namespace tractus::render {

Color color_from(Vec3f const& srgb)
{
    auto const byte = [](float value) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
    };
    return { byte(srgb.x()), byte(srgb.y()), byte(srgb.z()), 255 };
}

Vec3f linear_light(Vec3f const& srgb)
{
    return srgb.array().pow(2.2f);
}

Image::Image(int width, int height, Color fill)
    : width_(width)
    , height_(height)
{
    CHECK(width >= 0 && height >= 0);
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill);
}

std::size_t Image::index(int x, int y) const
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_)
        + static_cast<std::size_t>(x);
}

void paste(Image& onto, Image const& picture, int x, int y)
{
    int const first_column = std::max(0, -x);
    int const end_column = std::min(picture.width(), onto.width() - x);
    if (first_column >= end_column)
        return;
    int const end_row = std::min(picture.height(), onto.height() - y);
    for (int row = std::max(0, -y); row < end_row; ++row)
        std::copy_n(&picture.at(first_column, row), end_column - first_column,
                    &onto.at(x + first_column, y + row));
}

namespace {

// The source pixels that one destination pixel covers along one axis, with their weights.
struct Coverage {
    int first = 0;
    std::vector<float> weights; // Weight of each source pixel; their sum is 1.
};

std::vector<Coverage> coverages(int from, int to)
{
    std::vector<Coverage> result(static_cast<std::size_t>(to));
    double const step = static_cast<double>(from) / to;
    for (int i = 0; i < to; ++i) {
        double const begin = i * step;
        double const end = std::min<double>(begin + step, from);
        auto& coverage = result[static_cast<std::size_t>(i)];
        coverage.first = std::min(static_cast<int>(begin), from - 1);
        for (int source = coverage.first; source < end && source < from; ++source) {
            double const share
                = std::min<double>(source + 1, end) - std::max<double>(source, begin);
            coverage.weights.push_back(static_cast<float>(share / (end - begin)));
        }
    }
    return result;
}

Color mean_color(Image const& picture, Coverage const& across, Coverage const& down)
{
    std::array<float, 4> sum {};
    for (std::size_t row = 0; row < down.weights.size(); ++row) {
        for (std::size_t column = 0; column < across.weights.size(); ++column) {
            auto const& pixel = picture.at(across.first + static_cast<int>(column),
                                           down.first + static_cast<int>(row));
            float const weight = down.weights[row] * across.weights[column];
            sum[0] += weight * static_cast<float>(pixel.red);
            sum[1] += weight * static_cast<float>(pixel.green);
            sum[2] += weight * static_cast<float>(pixel.blue);
            sum[3] += weight * static_cast<float>(pixel.alpha);
        }
    }
    auto const byte = [](float value) { return static_cast<std::uint8_t>(std::lround(value)); };
    return { byte(sum[0]), byte(sum[1]), byte(sum[2]), byte(sum[3]) };
}

std::vector<std::uint8_t> without_alpha(Image const& picture)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(picture.pixels().size() * 3);
    for (auto const& pixel : picture.pixels())
        bytes.insert(bytes.end(), { pixel.red, pixel.green, pixel.blue });
    return bytes;
}

} // namespace

Image flipped(Image const& picture)
{
    Image result(picture.width(), picture.height());
    for (int row = 0; row < picture.height(); ++row)
        std::copy_n(&picture.at(0, picture.height() - 1 - row), picture.width(),
                    &result.at(0, row));
    return result;
}

Image resized(Image const& picture, int width, int height)
{
    CHECK(picture.width() > 0 && picture.height() > 0);
    Image result(width, height);
    auto const across = coverages(picture.width(), width);
    auto const down = coverages(picture.height(), height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            result.at(x, y) = mean_color(picture, across[static_cast<std::size_t>(x)],
                                         down[static_cast<std::size_t>(y)]);
    return result;
}

Result<void> write_png(std::ostream& out, Image const& picture)
{
    bool const opaque = std::ranges::all_of(picture.pixels(),
                                            [](auto const& pixel) { return pixel.alpha == 255; });
    if (picture.pixels().empty())
        return fail(
            Fault::Station,
            fmt::format("cannot make a PNG of {} x {} pixels", picture.width(), picture.height()));
    std::vector<std::uint8_t> channels;
    exports::PngPicture png {
        picture.width(), picture.height(), 4, {}, exports::PngPicture::Packing::Fast
    };
    if (opaque) {
        channels = without_alpha(picture);
        png.channels = 3;
        png.pixels = channels;
    } else {
        static_assert(sizeof(Color) == 4);
        auto const& pixels = picture.pixels();
        png.pixels = { reinterpret_cast<std::uint8_t const*>(pixels.data()), 4 * pixels.size() };
    }
    auto const bytes = exports::png_bytes(png);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out)
        return fail(Fault::Station, "cannot write the PNG: the stream takes no more bytes");
    return {};
}

} // namespace tractus::render
