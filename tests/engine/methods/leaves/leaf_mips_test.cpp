#include "engine/base/vectors.h"
#include "engine/methods/leaves/leaf_mips.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::leaf {
namespace {

// Returns a page of two by two cells: thin stripes, a disc, an empty cell and a full one.
CellPage alphas()
{
    CellPage page { .side = 512, .cell = 256 };
    for (int y = 0; y < page.side; ++y)
        for (int x = 0; x < page.side; ++x) {
            int const i = x % 256;
            int const j = y % 256;
            double alpha = x < 256 ? 0 : 1;
            if (y < 256 && x < 256)
                alpha = j > 20 && j < 200
                    ? 1.3 - std::abs(std::fmod(0.83 * i + 0.41 * j, 9.7) - 4.85)
                    : 0;
            else if (y < 256)
                alpha = 90.5 - std::hypot(i - 128, j - 128);
            alpha = 255 * std::clamp(alpha, 0.0, 1.0);
            for (int const value : { 80, 120, 40, static_cast<int>(std::lround(alpha)) })
                page.pixels.push_back(static_cast<std::uint8_t>(value));
        }
    return page;
}

TEST(LeafMips, KeepAsMuchOfEachLeafDownToSixteenPixels)
{
    auto page = alphas();
    auto const wanted = alpha_coverage(page);
    EXPECT_NEAR(wanted[1], kPi * 90 * 90 / 65536, 0.01);
    while (page.cell > 16) {
        page = half_page(page, PageKind::Color);
        auto shown = page;
        keep_coverage(shown, wanted);
        auto const found = alpha_coverage(shown);
        for (std::size_t cell = 0; cell < wanted.size(); ++cell)
            EXPECT_NEAR(found[cell], wanted[cell], page.cell > 16 ? 0.001 : 0.004)
                << page.cell << " " << cell;
    }
}

// Without keep_coverage(), thin parts of a leaf lose coverage in smaller pictures.
TEST(LeafMips, LoseWhatIsThinWhereNothingIsKept)
{
    auto page = alphas();
    auto const wanted = alpha_coverage(page);
    while (page.cell > 16)
        page = half_page(page, PageKind::Color);
    EXPECT_LT(alpha_coverage(page)[0], wanted[0] - 0.1);
}

TEST(LeafMips, KeepOneColorAndMixTwoInTheirLight)
{
    auto const page = half_page(alphas(), PageKind::Color);
    for (std::size_t i = 0; i < page.pixels.size(); i += 4) {
        ASSERT_EQ(page.pixels[i], 80);
        ASSERT_EQ(page.pixels[i + 1], 120);
    }
    CellPage const two { .side = 2, .cell = 2, .channels = 1, .pixels = { 0, 255, 255, 0 } };
    // A mixture of black and white has half of the light of white. In sRGB that is 188.
    EXPECT_EQ(half_page(two, PageKind::Color).pixels[0], 188);
    EXPECT_EQ(half_page(two, PageKind::Plain).pixels[0], 128);
}

TEST(LeafMips, KeepNormalsAtLengthOne)
{
    CellPage const page { .side = 2,
                          .cell = 2,
                          .channels = 3,
                          .pixels = { 218, 128, 218, 38, 128, 218, 218, 128, 218, 38, 128, 218 } };
    auto const half = half_page(page, PageKind::Normal);
    EXPECT_NEAR(half.pixels[0], 128, 1);
    EXPECT_NEAR(half.pixels[1], 128, 1);
    EXPECT_EQ(half.pixels[2], 255);
}

} // namespace
} // namespace tractus::leaf
