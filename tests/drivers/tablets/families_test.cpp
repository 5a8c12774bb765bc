// Tests makers' own formats with one report of each kind. Of Wacom's formats, only the Bamboo Pad's
// is tested here.

#include "drivers/pens/families.h"

#include "tests/drivers/bytes.h"

#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

namespace tractus::drivers {
namespace {

// Expected contents of a report; `tilt_deg` and `buttons` are 0 by default.
struct Expected {
    char const* family;
    char const* report;
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t pressure = 0;
    bool in_range = true;
    bool tip = false;
    bool invert = false;
    std::uint32_t buttons = 0;
    Vec2 tilt_deg = Vec2::Zero();
};

std::ostream& operator<<(std::ostream& out, Expected const& expected)
{
    return out << expected.family << ": " << expected.report;
}

std::optional<PenFields> decode(std::string_view family, std::string_view report)
{
    auto const* const found = find_pen_family(family);
    EXPECT_NE(found, nullptr) << family;
    FamilyState state;
    return found ? found->decode(bytes(report), state) : std::nullopt;
}

class FamilyReport : public testing::TestWithParam<Expected> { };

TEST_P(FamilyReport, SaysWhereThePenIs)
{
    auto const& expected = GetParam();
    auto const fields = decode(expected.family, expected.report);
    ASSERT_TRUE(fields);
    EXPECT_TRUE(fields->carries_position);
    EXPECT_EQ(fields->x, expected.x);
    EXPECT_EQ(fields->y, expected.y);
    EXPECT_EQ(fields->pressure.value_or(-1), expected.pressure);
    EXPECT_EQ(fields->in_range.value_or(true), expected.in_range);
    EXPECT_EQ(fields->tip.value_or(expected.pressure > 0), expected.tip);
    EXPECT_EQ(fields->invert, expected.invert);
    EXPECT_EQ(fields->buttons, expected.buttons);
    EXPECT_EQ(fields->tilt_deg.value_or(Vec2::Zero()), expected.tilt_deg);
}

constexpr bool kNear = true, kGone = false, kDown = true, kUp = false, kEraser = true, kPen = false;

Expected const kReports[] {
    { "generic", "01 81 6f 53 34 38 aa 00", 0x536f, 0x3834, 0xaa, kNear, kDown },
    // A format without a tip bit.
    { "generic", "01 80 6f 53 34 38 aa 00", 0x536f, 0x3834, 0xaa, kNear, kDown },
    { "generic", "01 8c 6f 53 34 38 00 00", 0x536f, 0x3834, 0, kNear, kUp, kPen, 6 },
    { "generic", "01 c0 6f 53 34 38 00 00", 0x536f, 0x3834, 0, kGone },

    { "uclogic-v1", "07 80 43 04 00 10 00 00", 0x0443, 0x1000 },
    { "uclogic-v1", "07 83 43 04 00 10 ff 07", 0x0443, 0x1000, 2047, kNear, kDown, kPen, 1 },
    { "uclogic-v1", "07 84 43 04 00 10 00 00", 0x0443, 0x1000, 0, kNear, kUp, kPen, 2 },
    { "uclogic-v1", "07 c0 43 04 00 10 00 00", 0x0443, 0x1000, 0, kGone },
    { "uclogic-v1-upright", "07 c1 43 04 00 10 ff 07", 0x0443, 0x1000, 2047, kNear, kDown },
    { "uclogic-v1-upright", "07 80 43 04 00 10 00 00", 0x0443, 0x1000, 0, kGone },

    // Reports of a Huion HS610 and of a New 1060 Plus.
    { "uclogic-v2", "08 81 33 55 21 43 2a 00 00 00 00 00", 0x5533, 0x4321, 42, kNear, kDown },
    { "uclogic-v2", "08 80 67 55 c2 3f 00 00 00 00 00 00", 0x5567, 0x3fc2 },
    { "uclogic-v2", "08 84 af 9c 45 48 00 00 00 00 00 00", 0x9caf, 0x4845, 0, kNear, kUp, kPen, 2 },
    { "uclogic-v2", "08 00 70 c6 06 7c 00 00 00 00 00 00", 50800, 31750, 0, kGone },
    // A report whose coordinates have 24 bits.
    { "uclogic-v2", "08 80 ed 73 35 d1 00 00 01 02 00 00", 0x173ed, 0x2d135 },
    { "uclogic-v2", "08 a1 ed 73 35 d1 01 00 00 00 00 00", 0x73ed, 0xd135, 1, kNear, kDown,
      kEraser },
    { "uclogic-v2-tilt",
      "08 81 0d 52 64 3a aa 00 00 00 f9 05",
      0x520d,
      0x3a64,
      170,
      kNear,
      kDown,
      kPen,
      0,
      { -7, -5 } },
    { "huion-giano",
      "08 85 0d 52 64 3a aa 40 01 00 f9 05",
      0x1520d,
      0x3a64,
      0x40aa,
      kNear,
      kDown,
      kPen,
      2,
      { 7, -5 } },

    { "xp-pen", "07 a1 f5 28 52 12 a3 03", 0x28f5, 0x1252, 931, kNear, kDown },
    { "xp-pen", "07 a0 4a 27 2b 11 00 00", 0x274a, 0x112b },
    { "xp-pen", "07 a2 76 26 f4 24 00 00", 0x2676, 0x24f4, 0, kNear, kUp, kPen, 1 },
    { "xp-pen", "07 c0 a4 24 00 00 00 00", 0x24a4, 0, 0, kGone },
    { "xp-pen", "07 80 0d 4b 12 00 00 00 00 00", 0x4b0d, 0x12, 0, kGone },
    { "xp-pen",
      "02 a9 4a 27 2b 11 ff 1f f6 0a",
      0x274a,
      0x112b,
      8191,
      kNear,
      kDown,
      kEraser,
      0,
      { -10, 10 } },
    { "xp-pen",
      "02 a1 4a 27 2b 11 01 00 3c c4 01 01",
      0x1274a,
      0x1112b,
      1,
      kNear,
      kDown,
      kPen,
      0,
      { 60, -60 } },
    { "xp-pen-offset-pressure", "02 a1 4a 27 2b 11 ff 3f 00 00 00 00", 0x274a, 0x112b, 8191, kNear,
      kDown },
    { "xp-pen-gen2",
      "02 a1 4a 27 2b 11 ff 5f 05 fb 01 00 00 01",
      0x1274a,
      0x112b,
      16383,
      kNear,
      kDown,
      kPen,
      0,
      { 5, -5 } },
    { "xp-pen-gen2", "02 a1 4a 27 2b 11 0a 40 00 00 00 00 00 00", 0x274a, 0x112b, 10, kNear,
      kDown },
    { "xp-pen-gen2", "02 c0 4a 27 2b 11 00 40 00 00 00 00 00 00", 0x274a, 0x112b, 0, kGone },
    { "xp-pen-offset-keys", "07 81 40 9c c0 5d ff 07", 40000, 24000, 2047, kNear, kDown },
    { "xp-pen-offset-keys", "07 c0 40 9c c0 5d 00 00", 40000, 24000, 0, kGone },
    { "xencelabs",
      "02 a1 64 cc a0 73 ff 1f 05 fb",
      52324,
      29600,
      8191,
      kNear,
      kDown,
      kPen,
      0,
      { 5, -5 } },
    { "xencelabs", "02 a8 64 cc a0 73 00 00 00 00", 52324, 29600, 0, kNear, kUp, kPen, 4 },
    { "xencelabs", "02 e0 64 cc a0 73 00 00 00 00", 52324, 29600, 0, kNear, kUp, kEraser },
    { "xencelabs", "02 c0 64 cc a0 73 00 00 00 00", 52324, 29600, 0, kGone },
    { "xenx", "01 03 a0 41 04 29 ff 1f", 16800, 10500, 8191, kNear, kDown, kPen, 1 },
    { "xenx", "01 41 a0 41 04 29 01 00", 16800, 10500, 1, kNear, kDown, kEraser },
    { "xenx", "01 00 00 00 00 00 00 00", 0, 0, 0, kGone },

    { "veikk-v1", "09 41 a1 70 c6 10 77 ff 1f", 50800, 30480, 8191, kNear, kDown },
    { "veikk-v1", "09 41 a4 70 c6 10 77 00 00", 50800, 30480, 0, kNear, kUp, kPen, 2 },
    { "veikk-v1", "09 41 c0 70 c6 10 77 00 00", 50800, 30480, 0, kGone },
    // A format without a tip bit.
    { "veikk-a15", "09 41 a0 70 c6 10 77 05 00", 50800, 30480, 5, kNear, kDown },
    { "veikk", "09 41 a3 e8 0c 01 c8 96 00 ff 1f 00 00", 68840, 38600, 8191, kNear, kDown, kPen,
      1 },
    { "veikk", "09 41 c0 e8 0c 01 c8 96 00 00 00 00 00", 68840, 38600, 0, kGone },
    { "veikk-tilt",
      "09 41 a1 10 77 00 50 4f 00 0a 00 fb 05",
      30480,
      20304,
      10,
      kNear,
      kDown,
      kPen,
      0,
      { -5, 5 } },
    { "acepen",
      "09 41 a1 70 c6 10 77 ff 1f 05 fb",
      50800,
      30480,
      8191,
      kNear,
      kDown,
      kPen,
      0,
      { 5, -5 } },
    { "acepen", "09 41 c0 70 c6 10 77 00 00 00 00", 50800, 30480, 0, kGone },

    { "wacom-bamboo-pad", "10 01 23 c2 29 18 1a ff 01", 10690, 6680, 511, kNear, kDown, kPen, 1 },
    { "wacom-bamboo-pad", "10 01 29 c2 29 18 1a 05 00", 10690, 6680, 5, kNear, kDown, kEraser },

    { "genius", "10 83 e2 36 00 28 ff 03", 14050, 10240, 1023, kNear, kDown, kPen, 1 },
    { "genius", "10 00 e2 36 00 28 00 00", 14050, 10240, 0, kGone },
    { "waltop", "02 00 30 00 24 0c ff 03", 12288, 9216, 1023, kNear, kDown, kPen, 1 },
    { "waltop", "02 00 30 00 24 10 05 00", 12288, 9216, 0, kNear, kUp, kPen, 2 },
    { "lifetec", "02 6f 17 93 11 08 ff 03", 5999, 4499, 1023, kNear, kDown, kPen, 1 },
    { "robotpen", "02 42 00 00 00 00 80 58 fc 40 ff 03", 22656, 16636, 1023, kNear, kDown },
    { "robotpen", "02 40 00 00 00 00 80 58 fc 40 00 00", 22656, 16636, 0, kGone },
    { "woodpad",
      "02 a0 41 00 00 90 29 00 00 07 ff 0f 05 fb",
      16800,
      10640,
      4095,
      kNear,
      kDown,
      kPen,
      0,
      { 5, -5 } },
    { "woodpad", "02 a0 41 00 00 90 29 00 00 13 ff 0f 00 00", 16800, 10640, 0, kNear, kUp, kPen,
      2 },
    { "woodpad", "02 a0 41 00 00 90 29 00 00 00 00 00 00 00", 16800, 10640, 0, kGone },
    { "floogoo",
      "01 20 a0 50 78 3c ff 7f e8 03 18 fc",
      20640,
      15480,
      32767,
      kNear,
      kDown,
      kPen,
      0,
      { 10, -10 } },
    { "floogoo", "01 2a a0 50 78 3c 00 00 00 00 00 00", 20640, 15480, 0, kNear, kUp, kEraser, 1 },
    { "floogoo", "01 00 a0 50 78 3c 00 00 00 00 00 00", 20640, 15480, 0, kGone },
};

INSTANTIATE_TEST_SUITE_P(All, FamilyReport, testing::ValuesIn(kReports));

struct NoPen {
    char const* family;
    char const* report;
};

std::ostream& operator<<(std::ostream& out, NoPen const& no_pen)
{
    return out << no_pen.family << ": " << no_pen.report;
}

class OtherReport : public testing::TestWithParam<NoPen> { };

TEST_P(OtherReport, IsNoPens)
{
    EXPECT_FALSE(decode(GetParam().family, GetParam().report));
}

NoPen const kOthers[] {
    { "uclogic-v1", "07 e0 01 01 01 00 00 00" },             // A report of keys.
    { "uclogic-v1", "09 80 43 04 00 10 00 00" },             // A report with another id.
    { "uclogic-v1-upright", "07 e0 01 10 01 00 00 00" },     // A report of a wheel.
    { "uclogic-v2", "08 f0 01 01 00 05 00 00 00 00 dd 10" }, // A report of an HS610's dial.
    { "uclogic-v2", "08 e0 01 01 01 00 00 00 00 00 00 00" }, // A report of keys.
    // An unexplained report that an HS610 sent once.
    { "uclogic-v2", "78 cc 00 08 78 cc 00 08 78 cc 00 08" },
    { "uclogic-v2-tilt", "08 e3 01 01 01 00 00 00 00 00 00 00" },
    { "huion-giano", "08 f1 01 01 00 05 00 00 00 00 00 00" },
    { "xp-pen", "02 f0 01 00 00 00 00 00 00 00" }, // A report of keys.
    { "xp-pen", "02 f2 01 64 00 00 00 00 00 00" }, // A report of the battery.
    { "xp-pen-gen2", "02 f0 01 00 00 00 00 00 00 00 00 00 00 00" },
    { "xp-pen-offset-keys", "07 a0 00 00 01 00 00 00" },        // A report of keys.
    { "xencelabs", "02 f0 01 00 00 00 00 00 00 00" },           // A report of keys.
    { "xenx", "02 01 00 00 00 00 00 00" },                      // A report of keys.
    { "veikk-v1", "03 00 01 00 00 00 00 00 00" },               // A report of keys.
    { "veikk", "09 42 01 01 01 00 00 00 00 00 00 00 00" },      // A report of keys.
    { "veikk-tilt", "09 43 a0 01 01 00 00 00 00 00 00 00 00" }, // A report of the touch pad.
    { "acepen", "09 42 01 01 01 00 00 00 00 00 00" },           // A report of keys.
    { "wacom-bamboo-pad", "10 06 01 00 00 00 00 00 00" },       // A report of keys.
    { "genius", "11 00 e2 36 00 28 00 00" },                    // A report of the tablet's mouse.
    { "waltop", "05 01 00 00 00 00 00 00" },                    // A report of keys.
    { "lifetec", "01 01 00 00 00 00 00 00" },
    { "floogoo", "02 20 a0 50 78 3c ff 7f e8 03 18 fc" },
};

INSTANTIATE_TEST_SUITE_P(All, OtherReport, testing::ValuesIn(kOthers));

TEST(Families, RefuseReportsThatAreTooShort)
{
    for (auto const& expected : kReports) {
        auto const whole = bytes(expected.report);
        auto const* const family = find_pen_family(expected.family);
        ASSERT_NE(family, nullptr);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            // On the heap, so that the sanitizer finds reads past its end.
            std::vector const cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            FamilyState state;
            bool const is_pens = family->decode(cut, state).has_value();
            EXPECT_FALSE(size < 8 && is_pens) << expected.family << " of " << size << " bytes";
        }
    }
}

} // namespace
} // namespace tractus::drivers
