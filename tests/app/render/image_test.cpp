#include "app/render/contact_sheet.h"
#include "app/render/read_picture.h"
#include "app/render/text.h"
#include "tests/app/render/read_png.h"

#include <algorithm>
#include <sstream>

namespace tractus::render {

namespace {

constexpr Color kBrick { 200, 10, 20, 255 };
constexpr Color kSlate { 10, 20, 200, 255 };

// Returns a picture whose pixels all differ, as far as their bytes allow.
Image gradient(int width, int height, std::uint8_t alpha)
{
    Image picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y)
                = { static_cast<std::uint8_t>(x * 7), static_cast<std::uint8_t>(y * 11),
                    static_cast<std::uint8_t>(x ^ y), alpha };
    return picture;
}

std::string png(Image const& picture)
{
    std::ostringstream out;
    auto const result = write_png(out, picture);
    EXPECT_TRUE(result) << result.error().message;
    return out.str();
}

// Returns the number of pixels in a rectangle whose colour is not `paper`.
int inked(Image const& picture, int left, int top, int width, int height, Color const& paper)
{
    int count = 0;
    for (int y = top; y < top + height; ++y)
        for (int x = left; x < left + width; ++x)
            count += picture.at(x, y) == paper ? 0 : 1;
    return count;
}

} // namespace

TEST(Image, ComesBackFromItsPng)
{
    auto const opaque = gradient(37, 23, 255);
    EXPECT_EQ(read_png(png(opaque)), opaque);
}

TEST(Image, KeepsTransparencyInItsPng)
{
    auto const sheer = gradient(12, 9, 77);
    EXPECT_EQ(read_png(png(sheer)), sheer);
}

TEST(ReadPicture, ReadsWhatLibpngReads)
{
    auto const bytes = png(gradient(37, 21, 128));
    auto const picture = read_picture(bytes);
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(*picture, read_png(bytes));
}

TEST(ReadPicture, RefusesWhatIsNone)
{
    EXPECT_EQ(read_picture("GIF89a").error().message, "it is neither a PNG nor a JPEG picture");
    auto const bytes = png(gradient(37, 21, 128));
    for (std::size_t size = 0; size + 12 < bytes.size(); ++size)
        EXPECT_FALSE(read_picture(bytes.substr(0, size))) << size;
}

TEST(ReadPicture, BelievesNoSizeThatAFileClaims)
{
    auto bytes = png(gradient(37, 21, 128));
    // The header is changed to claim a size of 983,040 squared pixels.
    bytes.replace(16, 8, std::string("\0\x0f\0\0\0\x0f\0\0", 8));
    auto const picture = read_picture(bytes);
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.error().fault, Fault::User);
}

TEST(Image, CannotBeAPngWhenEmpty)
{
    std::ostringstream out;
    auto const result = write_png(out, Image());
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Station);
}

TEST(Image, SaysWhenTheStreamIsFull)
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_FALSE(write_png(out, gradient(4, 4, 255)));
}

TEST(Image, PastesOnlyWhatLiesInside)
{
    Image sheet(10, 10, kBrick);
    paste(sheet, Image(4, 4, kSlate), -2, 8);
    EXPECT_EQ(std::ranges::count(sheet.pixels(), kSlate), 4);
    EXPECT_EQ(sheet.at(0, 8), kSlate);
    EXPECT_EQ(sheet.at(1, 9), kSlate);
    EXPECT_EQ(sheet.at(2, 8), kBrick);
}

TEST(Image, ShrinksToTheMeanOfWhatEachPixelCovers)
{
    Image picture(4, 2, { 0, 0, 0, 255 });
    for (int y = 0; y < 2; ++y)
        picture.at(0, y) = picture.at(3, y) = { 200, 100, 40, 255 };
    auto const small = resized(picture, 2, 1);
    EXPECT_EQ(small.at(0, 0), (Color { 100, 50, 20, 255 }));
    EXPECT_EQ(small.at(1, 0), (Color { 100, 50, 20, 255 }));
}

TEST(Text, InksItsLineAndNothingElse)
{
    constexpr Color kPaper { 255, 255, 255, 255 };
    Image picture(300, 80, kPaper);
    TextStyle const style { 24, { 0, 0, 0, 255 } };
    draw_text(picture, Vec2(20, 30), "Bäume 1–8", style);
    double const width_px = text_width_px("Bäume 1–8", style);
    EXPECT_GT(width_px, 80);
    EXPECT_LT(width_px, 180);
    int const line = inked(picture, 18, 30, static_cast<int>(width_px) + 4, 26, kPaper);
    EXPECT_GT(line, 400);
    EXPECT_EQ(inked(picture, 0, 0, 300, 80, kPaper), line);
}

TEST(Text, OutsideThePictureIsLeftOut)
{
    Image picture(20, 20, kBrick);
    draw_text(picture, Vec2(-500, -500), "far away", {});
    EXPECT_EQ(std::ranges::count(picture.pixels(), kBrick), 400);
}

TEST(ContactSheet, PutsTilesInRowsWithCaptionsBelow)
{
    std::vector<SheetTile> const tiles { { Image(60, 40, kBrick), "one" },
                                         { Image(60, 40, kSlate), "two" },
                                         { Image(60, 40, kBrick), "three" } };
    SheetStyle style;
    style.columns = 2;
    style.gap_px = 10;
    style.caption_size_px = 16;
    auto const sheet = contact_sheet(tiles, style);
    EXPECT_EQ(sheet.width(), 10 + 60 + 10 + 60 + 10);
    EXPECT_EQ(sheet.height(), 10 + 40 + 24 + 10 + 40 + 24 + 10);
    EXPECT_EQ(sheet.at(10, 10), kBrick);
    EXPECT_EQ(sheet.at(139, 49), kSlate);
    EXPECT_EQ(sheet.at(10, 84), kBrick);
    EXPECT_EQ(sheet.at(5, 5), style.paper);
    EXPECT_EQ(sheet.at(110, 100), style.paper) << "the last row is short";
    EXPECT_GT(inked(sheet, 10, 50, 60, 24, style.paper), 40) << "no caption below the first tile";
}

TEST(ContactSheet, LeavesRoomForATitleOnlyWhereThereIsOne)
{
    std::vector<SheetTile> const tiles { { Image(200, 40, kBrick), "" } };
    SheetStyle style;
    int const without = contact_sheet(tiles, style).height();
    style.title = "Varied";
    auto const sheet = contact_sheet(tiles, style);
    EXPECT_EQ(sheet.height() - without, 51);
    EXPECT_GT(inked(sheet, 0, 0, 200, 60, style.paper), 100);
}

} // namespace tractus::render
