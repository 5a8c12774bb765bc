#include "engine/base/mips.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace tractus {
namespace {

constexpr int kMipSide = 256;

// A picture whose alpha is a function of the place; outside the mask it has another colour.
PixelMap masked(std::function<double(int, int)> const& alpha)
{
    PixelMap made { .width = kMipSide, .height = kMipSide };
    for (int y = 0; y < kMipSide; ++y)
        for (int x = 0; x < kMipSide; ++x) {
            double const seen = std::clamp(alpha(x, y), 0.0, 1.0);
            bool const is_inside = seen > 0;
            for (int const value :
                 { is_inside ? 60 + x / 8 : 250, is_inside ? 120 : 10,
                   is_inside ? 20 + y / 16 : 250, static_cast<int>(std::lround(255 * seen)) })
                made.pixels.push_back(static_cast<std::uint8_t>(value));
        }
    return made;
}

PixelMap stripes()
{
    return masked([](int x, int y) {
        bool const is_there = y > 20 && y < 200;
        return is_there ? 1.3 - std::abs(std::fmod(0.83 * x + 0.41 * y, 9.7) - 4.85) : 0;
    });
}

PixelMap disc()
{
    return masked([](int x, int y) { return 90.5 - std::hypot(x - 128, y - 128); });
}

std::vector<std::uint8_t> alpha_of(PixelMap const& picture)
{
    std::vector<std::uint8_t> made;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4)
        made.push_back(picture.pixels[i]);
    return made;
}

double coverage(PixelMap const& picture)
{
    auto const alphas = alpha_of(picture);
    return double(std::ranges::count_if(alphas, [](int alpha) { return alpha >= 128; }))
        / double(alphas.size());
}

double mean_alpha(PixelMap const& picture)
{
    double sum = 0;
    for (int const alpha : alpha_of(picture))
        sum += alpha;
    return sum / (255 * double(picture.pixels.size() / 4));
}

double light(int byte)
{
    double const c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// Mean of a channel in linear light over the pixels that pass the alpha test.
double mean_light(PixelMap const& picture, std::size_t channel)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
        if (picture.pixels[i + 3] < 128)
            continue;
        sum += light(picture.pixels[i + channel]);
        ++count;
    }
    return sum / double(count);
}

std::vector<PixelMap> levels_of(PixelMap const& picture, int min_side = 4)
{
    AlphaMips const alpha(alpha_of(picture), picture.width, picture.height, min_side);
    return mip_levels(picture, MapKind::Color, alpha);
}

TEST(Mips, KeepCoverageAndMeanAlpha)
{
    for (auto const& picture : { stripes(), disc() }) {
        auto const levels = levels_of(picture);
        ASSERT_EQ(levels.size(), 6u);
        for (auto const& level : levels) {
            double const half_pixel = 0.5 / (level.width * level.height);
            EXPECT_NEAR(coverage(level), coverage(picture), half_pixel + 1e-9) << level.width;
            EXPECT_NEAR(mean_alpha(level), mean_alpha(picture), 0.005) << level.width;
        }
    }
}

// Without the two corrections, thin parts of a mask lose coverage in smaller pictures.
TEST(Mips, WouldLoseWhatIsThin)
{
    auto const picture = stripes();
    auto alphas = alpha_of(picture);
    for (int side = kMipSide; side > 16; side /= 2) {
        std::vector<std::uint8_t> half;
        auto const at
            = [&](int x, int y) { return int(alphas[static_cast<std::size_t>(y * side + x)]); };
        for (int y = 0; y < side; y += 2)
            for (int x = 0; x < side; x += 2)
                half.push_back(static_cast<std::uint8_t>(
                    (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1)) / 4));
        alphas = half;
    }
    auto const there = std::ranges::count_if(alphas, [](int alpha) { return alpha >= 128; });
    EXPECT_LT(double(there) / 256, coverage(picture) - 0.1);
}

TEST(Mips, KeepTheMeanColorOfWhatIsSeen)
{
    for (auto const& picture : { stripes(), disc() })
        for (auto const& level : levels_of(picture))
            for (std::size_t channel = 0; channel < 3; ++channel) {
                double const wanted = mean_light(picture, channel);
                EXPECT_NEAR(mean_light(level, channel), wanted, 0.01 * wanted)
                    << level.width << " " << channel;
            }
}

TEST(Mips, MixNothingFromOutsideTheMaskIntoIt)
{
    for (auto const& level : levels_of(disc()))
        for (std::size_t i = 0; i < level.pixels.size(); i += 4)
            if (level.pixels[i + 3] >= 128) {
                ASSERT_LT(level.pixels[i], 100) << level.width;
            }
}

TEST(Mips, MixTwoColorsInTheirLight)
{
    PixelMap const two { .width = 2, .height = 2, .channels = 1, .pixels = { 0, 255, 255, 0 } };
    AlphaMips const opaque({}, 2, 2, 1);
    // A mixture of black and white has half of the light of white. In sRGB that is 188.
    EXPECT_EQ(mip_levels(two, MapKind::Color, opaque)[0].pixels[0], 188);
    EXPECT_EQ(mip_levels(two, MapKind::Plain, opaque)[0].pixels[0], 128);
}

TEST(Mips, KeepNormalsAtLengthOne)
{
    PixelMap const map { .width = 2,
                         .height = 2,
                         .channels = 3,
                         .pixels = { 218, 128, 218, 38, 128, 218, 218, 128, 218, 38, 128, 218 } };
    auto const half = mip_levels(map, MapKind::Normal, AlphaMips({}, 2, 2, 1))[0];
    EXPECT_NEAR(half.pixels[0], 128, 1);
    EXPECT_NEAR(half.pixels[1], 128, 1);
    EXPECT_EQ(half.pixels[2], 255);
}

TEST(Mips, EndAtOnePixelWhateverTheSides)
{
    PixelMap picture { .width = 37, .height = 5, .channels = 4 };
    picture.pixels.assign(std::size_t { 37 } * 5 * 4, 255);
    auto const levels = levels_of(picture, 1);
    std::vector<std::array<int, 2>> sizes;
    for (auto const& level : levels) {
        sizes.push_back({ level.width, level.height });
        EXPECT_EQ(level.pixels.size(), static_cast<std::size_t>(4 * level.width * level.height));
        EXPECT_EQ(std::ranges::count(level.pixels, 255), std::ptrdiff_t(level.pixels.size()));
    }
    EXPECT_EQ(
        sizes,
        (std::vector<std::array<int, 2>> { { 18, 2 }, { 9, 1 }, { 4, 1 }, { 2, 1 }, { 1, 1 } }));
}

} // namespace
} // namespace tractus
