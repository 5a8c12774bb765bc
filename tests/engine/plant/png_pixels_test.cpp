#include "engine/plant/png_pixels.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

constexpr std::int64_t kMax = 100;

Result<PixelRows> read(std::string const& bytes, std::int64_t most_pixels = kMax)
{
    PixelRows rows;
    TRY(read_png_pixels(bytes, most_pixels, [&](int width, int height) {
        rows.width = width;
        rows.height = height;
        rows.rgba.resize(4 * static_cast<std::size_t>(width * height));
        return rows.rgba.data();
    }));
    return rows;
}

// Returns two columns and three rows of different pixels.
PixelRows six_pixels(std::uint8_t alpha)
{
    PixelRows rows { 2, 3, {} };
    for (std::uint8_t i = 0; i < 6; ++i)
        rows.rgba.insert(
            rows.rgba.end(),
            { static_cast<std::uint8_t>(40 * i), i, 200, i == 3 ? alpha : std::uint8_t { 255 } });
    return rows;
}

TEST(PngPixels, AreWrittenUpsideDown)
{
    for (auto const alpha : { std::uint8_t { 255 }, std::uint8_t { 10 } }) {
        auto const rows = six_pixels(alpha);
        auto const png = upside_down_png(rows);
        EXPECT_EQ(png[25], alpha == 255 ? 2 : 6) << "the colour type: alpha only if it is needed";
        auto const once = read(png);
        ASSERT_TRUE(once) << once.error().message;
        EXPECT_EQ(once->rgba[0], 160) << "the first row is the last one";
        auto const twice = read(upside_down_png(*once));
        ASSERT_TRUE(twice);
        EXPECT_EQ(twice->rgba, rows.rgba);
        EXPECT_EQ(upside_down_png(rows), png);
    }
}

TEST(PngPixels, RefuseWhatIsDamagedOrTooLarge)
{
    auto const png = upside_down_png(six_pixels(255));
    EXPECT_TRUE(read(png, 6));
    auto const large = read(png, 5);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().message,
              "the picture has 2 x 3 pixels, more than 0 million: make it smaller");
    EXPECT_EQ(large.error().fault, Fault::User);
    // The end chunk itself may be missing.
    for (std::size_t size = 0; size < png.size() - 12; ++size)
        EXPECT_FALSE(read(png.substr(0, size))) << size;
    // A header that claims 65,536 x 65,536 pixels.
    auto claims = png;
    claims.replace(16, 8, std::string("\0\1\0\0\0\1\0\0", 8));
    EXPECT_FALSE(read(claims));
}

} // namespace
} // namespace tractus
