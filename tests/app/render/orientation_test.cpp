#include "app/render/read_picture.h"

#include <array>
#include <gtest/gtest.h>
#include <string>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace tractus::render {
namespace {

// Returns a blue JPEG image whose first row begins with red and ends with green.
std::string jpeg(int width, int height)
{
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            bool const is_above = y < height / 2;
            bool const is_left = x < width / 2;
            pixels.push_back(is_above && is_left ? 255 : 0);
            pixels.push_back(is_above && !is_left ? 255 : 0);
            pixels.push_back(is_above ? 0 : 255);
        }
    std::string bytes;
    stbi_write_jpg_to_func(
        [](void* to, void* data, int size) {
            static_cast<std::string*>(to)->append(static_cast<char const*>(data),
                                                  static_cast<std::size_t>(size));
        },
        &bytes, width, height, 3, pixels.data(), 100);
    return bytes;
}

// Inserts an Exif segment with the given orientation (Exif 2.32, section 4.5.4). The segment is an
// APP1 marker, a TIFF header and one entry of type SHORT.
std::string with_orientation(std::string const& jpeg, int orientation)
{
    std::string tiff("MM\0\x2a\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\0\0\0\0\0\0\0", 26);
    tiff[19] = static_cast<char>(orientation);
    auto const body = std::string("Exif\0\0", 6) + tiff;
    std::string marker("\xff\xe1\0", 3);
    marker += static_cast<char>(body.size() + 2);
    return jpeg.substr(0, 2) + marker + body + jpeg.substr(2);
}

bool is_red(Color const& color)
{
    return color.red > 200 && color.green < 60;
}
bool is_green(Color const& color)
{
    return color.green > 200 && color.red < 60;
}

// Visible positions of the beginning and end of a picture's first row, by its Exif orientation. In
// the standard's words for orientation 6: the 0th row is the visual right-hand side, and the 0th
// column is the visual top.
struct Seen {
    int orientation = 1;
    bool begins_right = false;
    bool begins_below = false;
    bool ends_right = true;
    bool ends_below = false;
};
constexpr std::array kSeen {
    Seen { 1, false, false, true, false }, Seen { 2, true, false, false, false },
    Seen { 3, true, true, false, true },   Seen { 4, false, true, true, true },
    Seen { 5, false, false, false, true }, Seen { 6, true, false, true, true },
    Seen { 7, true, true, true, false },   Seen { 8, false, true, false, false },
};

TEST(ReadPicture, IsUprightAsTheCameraSays)
{
    constexpr int kWidth = 64;
    constexpr int kHeight = 32;
    for (auto const& seen : kSeen) {
        auto const picture
            = read_picture(with_orientation(jpeg(kWidth, kHeight), seen.orientation));
        ASSERT_TRUE(picture) << picture.error().message;
        bool const is_turned = seen.orientation >= 5;
        EXPECT_EQ(picture->width(), is_turned ? kHeight : kWidth) << seen.orientation;
        EXPECT_EQ(picture->height(), is_turned ? kWidth : kHeight) << seen.orientation;
        auto const corner = [&](bool is_right, bool is_below) {
            return picture->at(is_right ? picture->width() - 4 : 3,
                               is_below ? picture->height() - 4 : 3);
        };
        EXPECT_TRUE(is_red(corner(seen.begins_right, seen.begins_below))) << seen.orientation;
        EXPECT_TRUE(is_green(corner(seen.ends_right, seen.ends_below))) << seen.orientation;
    }
}

// An Exif segment of the greatest size, each of whose thousands of entries claims most of the
// segment as its value, and whose pointers lead back to the same entries.
std::string with_exif_bomb(std::string const& jpeg)
{
    constexpr std::size_t kMaxSegmentBytes = 65'533;
    constexpr std::size_t kEntries = 5400;
    auto const number = [](std::size_t value, int bytes) {
        std::string text;
        for (int i = bytes - 1; i >= 0; --i)
            text += static_cast<char>(value >> 8 * i & 0xff);
        return text;
    };
    auto const entry = [&](std::size_t tag, std::size_t type, std::size_t count, std::size_t at) {
        return number(tag, 2) + number(type, 2) + number(count, 4) + number(at, 4);
    };
    constexpr std::size_t kBegin = 8; // Of the entries, in the TIFF structure.
    auto body = std::string("Exif\0\0MM\0\x2a", 10) + number(kBegin, 4) + number(kEntries, 2);
    // Pointers to the entries for Exif, GPS and interoperability.
    for (std::size_t const tag : { 0x8769U, 0x8825U, 0xa005U })
        body += entry(tag, 4, 1, kBegin);
    // The model, the description, the user's comment and the maker's note, as bytes.
    constexpr std::array<std::size_t, 4> kTags { 0x0110, 0x010e, 0x9286, 0x927c };
    for (std::size_t i = 3; i < kEntries; ++i)
        body += entry(kTags[i % kTags.size()], 7, 60'000, kBegin);
    body += number(kBegin, 4); // The next list of entries is the same one.
    body.resize(kMaxSegmentBytes);
    return jpeg.substr(0, 2) + "\xff\xe1" + number(body.size() + 2, 2) + body + jpeg.substr(2);
}

TEST(ReadPicture, ReadsAPictureWhoseExifDataHaveNoEnd)
{
    auto const picture = read_picture(with_exif_bomb(jpeg(16, 8)));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(picture->width(), 16);
    EXPECT_TRUE(is_red(picture->at(3, 1)));
}

// Returns a JPEG that claims another size.
std::string claiming(std::string jpeg, int width, int height)
{
    auto const frame = jpeg.find("\xff\xc0");
    EXPECT_NE(frame, std::string::npos);
    std::size_t at = frame + 5;
    for (int const side : { height, width }) {
        jpeg[at++] = static_cast<char>(side >> 8);
        jpeg[at++] = static_cast<char>(side & 0xff);
    }
    return jpeg;
}

TEST(ReadPicture, GetsNoMemoryForAJpegThatIsNotThere)
{
    auto const small = jpeg(64, 32);
    auto const large = read_picture(claiming(small, 65'000, 65'000));
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().message,
              "the picture has 65000 x 65000 pixels, more than 100 million: make it smaller");
    auto const missing = read_picture(claiming(small, 10'000, 10'000));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().message,
              "the picture is damaged: it holds less than its 10000 x 10000 pixels: save it again");
    EXPECT_EQ(missing.error().fault, Fault::User);
}

TEST(ReadPicture, ReadsWhatIsLeftOfACutJpeg)
{
    auto const whole = jpeg(640, 320);
    auto const picture = read_picture(whole.substr(0, whole.size() / 2));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(picture->width(), 640);
    EXPECT_TRUE(is_red(picture->at(3, 3)));
}

// A plain surface of one color takes the fewest bytes for its size.
TEST(ReadPicture, ReadsALargePlainJpeg)
{
    auto const picture = read_picture(jpeg(4096, 4096));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_TRUE(is_red(picture->at(0, 0)));
    EXPECT_TRUE(is_green(picture->at(4095, 0)));
}

TEST(ReadPicture, TakesNonsenseForUpright)
{
    for (int const orientation : { 0, 9, 200 }) {
        auto const picture = read_picture(with_orientation(jpeg(16, 8), orientation));
        ASSERT_TRUE(picture) << picture.error().message;
        EXPECT_EQ(picture->width(), 16);
    }
}

} // namespace
} // namespace tractus::render
