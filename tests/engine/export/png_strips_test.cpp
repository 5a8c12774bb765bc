#include "engine/export/png.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <png.h>
#include <string>
#include <vector>

namespace tractus::exports {
namespace {

// The picture as decoded by libpng.
std::vector<std::uint8_t> decoded(std::string const& file, png_uint_32 format)
{
    png_image image {};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0)
        << image.message;
    image.format = format;
    std::vector<std::uint8_t> made(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, made.data(), 0, nullptr), 0) << image.message;
    return made;
}

TEST(PngStrips, AreReadByLibpng)
{
    constexpr int kSide = 96;
    for (int const channels : { 1, 3, 4 }) {
        std::vector<std::uint8_t> pixels;
        for (int i = 0; i < kSide * kSide * channels; ++i)
            pixels.push_back(static_cast<std::uint8_t>(i % 7 == 0 ? i * i >> 5 : i / 700));
        auto const row = static_cast<std::size_t>(kSide * channels);
        for (std::size_t const rows : { 1u, 32u, 96u }) {
            PngStrips strips(kSide, kSide, channels);
            auto file = strips.header();
            for (std::size_t y = 0; y < kSide; y += rows) {
                auto const from = std::span<std::uint8_t const>(pixels).subspan(y * row);
                auto const above = y == 0
                    ? std::span<std::uint8_t const>()
                    : std::span<std::uint8_t const>(pixels).subspan((y - 1) * row, row);
                strips.append(strips.pack(from.first(rows * row), above), file);
            }
            file += strips.end();
            auto const format = channels == 1 ? PNG_FORMAT_GRAY
                : channels == 3               ? PNG_FORMAT_RGB
                                              : PNG_FORMAT_RGBA;
            EXPECT_EQ(decoded(file, format), pixels) << channels << " " << rows;
        }
    }
}

} // namespace
} // namespace tractus::exports
