#include "engine/export/texture.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <zlib.h>

namespace tractus::exports {
namespace {

std::uint32_t u32_be_at(std::string const& bytes, std::size_t offset)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

std::uint8_t level(GreyPicture const& picture, int x, int y)
{
    return picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
}

// Returns the mean difference between the pixels of two columns.
double column_step(GreyPicture const& picture, int a, int b)
{
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        sum += std::abs(level(picture, a, y) - level(picture, b, y));
    return sum / picture.height;
}

double row_step(GreyPicture const& picture, int a, int b)
{
    double sum = 0;
    for (int x = 0; x < picture.width; ++x)
        sum += std::abs(level(picture, x, a) - level(picture, x, b));
    return sum / picture.width;
}

TEST(Texture, BarkTilesInBothDirections)
{
    auto const bark = bark_picture();
    double columns = 0;
    double rows = 0;
    for (int i = 1; i < bark.width; ++i) {
        columns += column_step(bark, i - 1, i) / (bark.width - 1);
        rows += row_step(bark, i - 1, i) / (bark.height - 1);
    }
    EXPECT_GT(columns, 2); // The texture must not be uniform.
    EXPECT_LT(column_step(bark, bark.width - 1, 0), 2 * columns);
    EXPECT_LT(row_step(bark, bark.height - 1, 0), 2 * rows);
}

TEST(Texture, ALeafIsMirroredAboutItsMidribAndLightestThere)
{
    auto const leaf = leaf_picture();
    for (int y = 0; y < leaf.height; y += 16) {
        for (int x = 0; x < leaf.width / 2; ++x)
            ASSERT_EQ(level(leaf, x, y), level(leaf, leaf.width - 1 - x, y));
        EXPECT_GT(level(leaf, leaf.width / 2, y), level(leaf, 0, y));
    }
}

TEST(Texture, WritesAPngThatUnpacksToItsPixels)
{
    GreyPicture const picture { 3, 2, { 1, 2, 3, 4, 255, 0 } };
    auto const png = png_bytes(picture);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(u32_be_at(png, 16), 3u);
    EXPECT_EQ(u32_be_at(png, 20), 2u);
    auto const size = u32_be_at(png, 33);
    EXPECT_EQ(png.substr(37, 4), "IDAT");
    std::string rows(8, '\0');
    uLongf length = rows.size();
    ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &length,
                         reinterpret_cast<Bytef const*>(png.data() + 41), size),
              Z_OK);
    EXPECT_EQ(rows,
              // Each row: filter type 2 (Up), then the differences from the bytes of the row above.
              std::string("\x02\x01\x02\x03\x02\x03\xfd\xfd", 8));
    auto const sum = crc32(0, reinterpret_cast<Bytef const*>(png.data() + 37), size + 4);
    EXPECT_EQ(u32_be_at(png, 41 + size), sum);
}

} // namespace
} // namespace tractus::exports
