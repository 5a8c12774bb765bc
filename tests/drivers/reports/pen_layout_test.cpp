#include "drivers/reports/pen_layout.h"

#include "tests/drivers/devices.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

std::vector<PenLayout> layouts(std::string const& text)
{
    auto const descriptor = parse_report_descriptor(bytes(text));
    EXPECT_TRUE(descriptor) << descriptor.error().message;
    return descriptor ? find_pen_layouts(*descriptor) : std::vector<PenLayout>();
}

// Returns the layouts of a pen with the given items for its axes, X and Y.
std::vector<PenLayout> pen_with_axes(std::string const& x, std::string const& y,
                                     std::string const& tilt = "")
{
    return layouts("05 0d 09 02 a1 01 09 20 a1 00 15 00 25 01 75 01 95 01 09 42 81 02 95 07 81 03"
                   "05 01 75 10 95 01"
                   + x + "09 30 81 02" + y + "09 31 81 02" + tilt + "c0 c0");
}

TEST(PenLayout, FindsTheFieldsOfADigitizerPen)
{
    auto const descriptor = parse_report_descriptor(simple_pen().report_descriptor);
    ASSERT_TRUE(descriptor);
    auto const found = find_pen_layouts(*descriptor);
    ASSERT_EQ(found.size(), 1u);
    auto const& pen = found[0];
    EXPECT_EQ(pen.report_id, 2);
    EXPECT_EQ(pen.report_size, 10u);
    EXPECT_EQ(pen.bytes_needed, 10u);
    EXPECT_EQ(pen.size_source, PenLayout::Size::Declared);
    EXPECT_NEAR(pen.size_mm.x(), 200, 1e-9);
    EXPECT_NEAR(pen.size_mm.y(), 100, 1e-9);
    EXPECT_NEAR(pen.mm_per_count.x(), 0.01, 1e-12);
    EXPECT_TRUE(pen.tip && pen.in_range && pen.invert && pen.eraser && pen.pressure);
    EXPECT_TRUE(pen.buttons[0] && pen.buttons[1] && !pen.buttons[2]);
    EXPECT_NEAR(pen.tilt_rad_per_count.y(), radians(1.0), 1e-12);
}

TEST(PenLayout, TakesAMouseWithTipPressureForAPen)
{
    // A mouse with tip pressure: three buttons and padding, X and Y 0 to 32767, pressure 0 to 8191.
    auto const found = layouts(
        "05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
        "95 05 81 01 05 01 09 30 09 31 26 ff 7f 95 02 75 10 81 02"
        "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].tip->usage, 0x0009'0001u);
    EXPECT_EQ(found[0].buttons[0]->usage, 0x0009'0002u);
    EXPECT_FALSE(found[0].in_range);
    EXPECT_EQ(found[0].size_source, PenLayout::Size::Assumed);
}

TEST(PenLayout, TakesNoOrdinaryMouseForAPen)
{
    EXPECT_TRUE(
        layouts("05 01 09 02 a1 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
                "95 01 75 05 81 01 05 01 09 30 09 31 15 81 25 7f 75 08 95 02 81 06 c0 c0")
            .empty());
}

TEST(PenLayout, TakesNoFingerForAPen)
{
    // A touch screen's finger: tip, X, Y.
    EXPECT_TRUE(
        layouts("05 0d 09 04 a1 01 09 22 a1 02 09 42 15 00 25 01 75 01 95 01 81 02 95 07 81 03"
                "05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 c0 c0")
            .empty());
}

TEST(PenLayout, FindsOneLayoutPerReportId)
{
    auto const one = std::string("09 20 a1 00 05 0d 09 42 15 00 25 01 75 01 95 01 81 02 95 07 81 03"
                                 "05 01 09 30 09 31 26 ff 7f 75 10 95 02 81 02 c0 05 0d");
    auto const found = layouts("05 0d 09 02 a1 01 85 06" + one + "85 07" + one + "c0");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].report_id, 6);
    EXPECT_EQ(found[1].report_id, 7);
}

TEST(PenLayout, DistrustsASizeThatNoTabletHas)
{
    // Descriptor of a VEIKK tablet of 254 x 158.75 mm: 50800 x 31750 counts on 0.820 x 1.101
    // inches.
    auto const found
        = pen_with_axes("27 70 c6 00 00 35 00 46 34 03 65 13 55 0d", "27 06 7c 00 00 46 4d 04");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].size_source, PenLayout::Size::Assumed);
    EXPECT_NEAR(found[0].size_mm.x(), 254, 1e-9);
    EXPECT_NEAR(found[0].size_mm.y(), 158.75, 1e-9);
}

TEST(PenLayout, ReadsAPhysicalRangeWithoutUnitAsThousandthsOfAnInch)
{
    // An XP-Pen display of 344 x 195 mm: 34419 x 19461 counts on 13551 x 7662 without a unit.
    auto const found = pen_with_axes("27 73 86 00 00 35 00 46 ef 34", "26 05 4c 46 ee 1d");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].size_mm.x(), 344.2, 0.1);
    EXPECT_NEAR(found[0].size_mm.y(), 194.6, 0.1);
}

TEST(PenLayout, GuessesASizeWhereTheDescriptorHasNone)
{
    // Axes of 20000 x 10000 counts without a size: 5080 counts per inch are assumed.
    auto const usual = pen_with_axes("26 20 4e", "26 10 27");
    ASSERT_EQ(usual.size(), 1u);
    EXPECT_NEAR(usual[0].size_mm.x(), 100, 1e-9);
    EXPECT_NEAR(usual[0].size_mm.y(), 50, 1e-9);
    auto const coarse = pen_with_axes("26 e8 03", "26 f4 01"); // A range of 1000 x 500 counts.
    ASSERT_EQ(coarse.size(), 1u);
    EXPECT_NEAR(coarse[0].size_mm.x(), 250, 1e-9);
}

TEST(PenLayout, GivesAMouseTheSizeOfItsPen)
{
    auto pen = simple_pen().report_descriptor;
    auto const mouse = bytes(
        "05 01 09 02 a1 01 85 09 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
        "95 05 81 01 05 01 09 30 09 31 65 00 35 00 45 00 26 ff 7f 95 02 75 10 81 02"
        "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0");
    pen.insert(pen.end(), mouse.begin(), mouse.end());
    auto const descriptor = parse_report_descriptor(pen);
    ASSERT_TRUE(descriptor);
    auto const found = find_pen_layouts(*descriptor);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].report_id, 9);
    EXPECT_NEAR(found[1].size_mm.x(), 200, 1e-9);
}

TEST(PenLayout, UnderstandsTiltWithoutUnits)
{
    auto const tilt = [](std::string const& range) {
        auto const found
            = pen_with_axes("26 20 4e", "26 10 27", "05 0d" + range + "09 3d 09 3e 95 02 81 02");
        return found.empty() ? 0 : found[0].tilt_rad_per_count.x();
    };
    EXPECT_NEAR(tilt("15 81 25 7f 75 08"), radians(1.0), 1e-12); // Range -127 to 127 means degrees.
    EXPECT_NEAR(tilt("16 d8 dc 26 28 23 75 10"), radians(0.01),
                1e-12); // Range -9000 to 9000 means hundredths of a degree.
    // Range -32767 to 32767 spans 180 degrees.
    EXPECT_NEAR(tilt("16 01 80 26 ff 7f 75 10"), radians(180.0) / 65534, 1e-12);
}

TEST(PenLayout, IgnoresAnEmptyRange)
{
    EXPECT_TRUE(pen_with_axes("25 00", "26 10 27").empty());
}

} // namespace
} // namespace tractus::drivers
