#include "drivers/tablets/tablet_parameters.h"

#include "drivers/usb/string_descriptor.h"
#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

// Returns the text of string 200 of a Huion HS610. The descriptor's length and type are not part of
// it.
std::string hs610_string_200()
{
    return string_descriptor_text(bytes("70 c6 00 06 7c 00 ff 1f d8 13 00 00 00 00 00 00 00"));
}

TEST(StringDescriptor, IsText)
{
    EXPECT_EQ(string_descriptor_text(bytes("48 00 53 00 36 00 31 00 30 00")), "HS610");
    EXPECT_EQ(string_descriptor_text(bytes("e9 00 ac 20 3d d8 00 de")), "\u00e9\u20ac\U0001F600");
    EXPECT_EQ(string_descriptor_text({}), "");
}

TEST(StringDescriptor, KeepsNumbersThatAreNoText)
{
    // The texts contain zeros, unpaired and swapped surrogates, and line ends.
    for (auto const* const text : { "00 00 0a 00", "00 d8 41 00", "00 dc 00 d8", "ff ff 3d d8" })
        EXPECT_EQ(string_descriptor_bytes(string_descriptor_text(bytes(text))), bytes(text))
            << text;
}

TEST(StringDescriptor, DropsALastOddByte)
{
    EXPECT_EQ(string_descriptor_bytes(string_descriptor_text(bytes("41 00 42"))), bytes("41 00"));
}

TEST(StringDescriptor, SurvivesTextThatIsNoUtf8)
{
    EXPECT_EQ(string_descriptor_bytes("\xc3"), bytes("c3 00"));
    EXPECT_EQ(string_descriptor_bytes("a\xe2\x82"), bytes("61 00 e2 00"));
}

TEST(Parameters, OfString200AreSizeAndRanges)
{
    auto const told = parse_parameters(200, hs610_string_200());
    ASSERT_TRUE(told);
    EXPECT_EQ(*told, (TabletParameters { 50800, 31750, 8191, 5080 }));
    EXPECT_NEAR(told->size_mm().x(), 254, 1e-9);
    EXPECT_NEAR(told->size_mm().y(), 158.75, 1e-9);
}

TEST(Parameters, OfString200MayNeed24Bits)
{
    // String 200 with X up to 95213, Y up to 53557, 16383 levels, 5080 counts per inch: 476 x 268
    // mm.
    auto const told = parse_parameters(
        200, string_descriptor_text(bytes("ed 73 01 35 d1 00 ff 3f d8 13 00 00 00 00 00 00")));
    ASSERT_TRUE(told);
    EXPECT_EQ(told->x_maximum, 95213);
    EXPECT_EQ(told->y_maximum, 53557);
    EXPECT_EQ(told->pressure_maximum, 16383);
}

TEST(Parameters, OfString100Have16Bits)
{
    // String 100 with X up to 40000, Y up to 25000, 8 keys, frame type 1, 2047 levels, 4000 counts
    // per inch.
    auto const told
        = parse_parameters(100, string_descriptor_text(bytes("40 9c a8 61 08 01 ff 07 a0 0f")));
    ASSERT_TRUE(told);
    EXPECT_EQ(*told, (TabletParameters { 40000, 25000, 2047, 4000 }));
}

TEST(Parameters, AreNotInOtherStrings)
{
    EXPECT_FALSE(parse_parameters(201, hs610_string_200()));
    EXPECT_FALSE(parse_parameters(200, "HUION_T194_180726"));
    EXPECT_FALSE(parse_parameters(200, ""));
    EXPECT_FALSE(parse_parameters(100, "short"));
}

TEST(Parameters, MustMakeSense)
{
    auto const with = [](std::string_view text) {
        return parse_parameters(100, string_descriptor_text(bytes(text)));
    };
    EXPECT_FALSE(with("40 9c a8 61 00 00 00 00 a0 0f")); // Parameters without pressure.
    EXPECT_FALSE(with("40 9c a8 61 00 00 ff 07 00 00")); // Parameters without resolution.
    EXPECT_FALSE(with("40 9c a8 61 00 00 ff 07 64 00")); // A width of 10 m.
    EXPECT_FALSE(with("00 08 00 08 00 00 ff 07 a0 0f")); // A width of 13 mm.
}

} // namespace
} // namespace tractus::drivers
