#include "engine/plant/png_pixels.h"

#include <gtest/gtest.h>
#include <zlib.h>

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

// Returns a picture of two columns and three rows of different pixels.
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
    // A file is valid without its end chunk, so the truncation begins before that chunk.
    for (std::size_t size = 0; size < png.size() - 12; ++size)
        EXPECT_FALSE(read(png.substr(0, size))) << size;
    // The header is changed to claim 65,536 x 65,536 pixels.
    auto claims = png;
    claims.replace(16, 8, std::string("\0\1\0\0\0\1\0\0", 8));
    EXPECT_FALSE(read(claims));
}

// Appends a chunk to a PNG: its length, type, data and checksum.
void add_chunk(std::string& png, std::string const& type, std::string const& data)
{
    auto const add_number = [&](std::uint64_t number) {
        for (int const shift : { 24, 16, 8, 0 })
            png += static_cast<char>(number >> shift & 0xff);
    };
    add_number(data.size());
    auto const begin = png.size();
    png += type + data;
    add_number(crc32(0, reinterpret_cast<Bytef const*>(png.data()) + begin,
                     static_cast<uInt>(png.size() - begin)));
}

struct Header {
    int width = 0;
    int height = 0;
    char depth = 8;
    char color_type = 6;
    char interlaced = 0;
};

// Returns a PNG whose uncompressed rows are the given bytes, in data chunks of `chunk_bytes`.
std::string png_of(Header const& header, std::string const& rows, std::size_t chunk_bytes = 1 << 20)
{
    std::string text;
    for (int const number : { header.width, header.height })
        for (int const shift : { 24, 16, 8, 0 })
            text += static_cast<char>(number >> shift & 0xff);
    text += { header.depth, header.color_type, 0, 0, header.interlaced };
    std::string png("\x89PNG\r\n\x1a\n");
    add_chunk(png, "IHDR", text);
    auto size = compressBound(rows.size());
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
              reinterpret_cast<Bytef const*>(rows.data()), rows.size(), 9);
    packed.resize(size);
    for (std::size_t at = 0; at < packed.size(); at += chunk_bytes)
        add_chunk(png, "IDAT", packed.substr(at, chunk_bytes));
    add_chunk(png, "IEND", "");
    return png;
}

TEST(PngPixels, MayBeOfAnyDepthInterlacedAndInManyChunks)
{
    EXPECT_TRUE(read(png_of({ 9, 2, 1, 0, 0 }, std::string(6, '\0'))));
    EXPECT_TRUE(read(png_of({ 3, 3, 8, 0, 1 }, std::string(15, '\0'))));
    EXPECT_TRUE(read(png_of({ 5, 5, 16, 6, 0 }, std::string(205, '\0'), 1)));
}

// A file of 20 kB whose data would inflate to 20 MB must be refused.
TEST(PngPixels, RefuseToInflateFarMoreThanTheyAre)
{
    auto const bomb = png_of({ 10, 10 }, std::string(20'000'000, '\0'));
    ASSERT_LT(bomb.size(), 30'000u);
    auto const refused = read(bomb);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the picture is damaged: it holds far more than its 10 x 10 pixels: save it again");
}

// Texts that would inflate to 800 MB must not be inflated.
TEST(PngPixels, AreReadWithoutInflatingTexts)
{
    auto const png = upside_down_png(six_pixels(255));
    std::string unused;
    EXPECT_EQ(without_texts(png, unused).data(), png.data()) << "nothing is copied";

    auto size = compressBound(8'000'000);
    std::string bomb(size, '\0');
    std::string const zeros(8'000'000, '\0');
    compress2(reinterpret_cast<Bytef*>(bomb.data()), &size,
              reinterpret_cast<Bytef const*>(zeros.data()), zeros.size(), 9);
    bomb.resize(size);
    constexpr std::size_t kEndOfHeader = 33;
    auto laden = png.substr(0, kEndOfHeader);
    for (int i = 0; i < 50; ++i) {
        add_chunk(laden, "zTXt", std::string("a\0\0", 3) + bomb);
        add_chunk(laden, "iTXt", std::string("a\0\1\0\0\0", 6) + bomb);
    }
    add_chunk(laden, "tEXt", std::string("a\0b", 3));
    laden += png.substr(kEndOfHeader);
    std::string copy;
    EXPECT_EQ(without_texts(laden, copy), png);
    EXPECT_EQ(read(laden).value().rgba, read(png).value().rgba);
}

TEST(PngPixels, TextsAreLeftOutOfDamagedFiles)
{
    auto png = upside_down_png(six_pixels(255));
    auto const whole = png;
    add_chunk(png, "zTXt", "text");
    for (auto size = whole.size(); size < png.size(); ++size) {
        std::string copy;
        auto const left = without_texts(std::string_view(png).substr(0, size), copy);
        EXPECT_TRUE(left.starts_with(whole)) << size;
        EXPECT_LE(left.size(), size);
    }
    for (std::string const few : { "", "\x89PNG" }) {
        std::string copy;
        EXPECT_EQ(without_texts(few, copy), few);
    }
}

TEST(PngPixels, GetNoMemoryForWhatIsClaimedAndNotThere)
{
    auto const refused
        = read_png_pixels(png_of({ 10'000, 10'000 }, "few"), 100'000'000, [](int, int) {
              ADD_FAILURE() << "it asks for 400 MB";
              return static_cast<std::uint8_t*>(nullptr);
          });
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message,
              "the picture is damaged: it holds less than its 10000 x 10000 pixels: save it again");
}

} // namespace
} // namespace tractus
