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
