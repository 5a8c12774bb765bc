
#include "drivers/tablets/pen_decoders.h"
#include "tests/drivers/decode_one.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

// Fixture that decodes the reports of simple_pen().
class PenDecoderTest : public testing::Test {
protected:
    Result<std::optional<PenSample>> decode(std::string const& report)
    {
        time_ += Duration(5'000'000);
        return decode_one(*decoder_, time_, bytes(report));
    }

    // Returns the sample of a report that must have one.
    PenSample sample(std::string const& report)
    {
        auto const result = decode(report);
        EXPECT_TRUE(result) << result.error().message;
        EXPECT_TRUE(result && *result) << "no sample for " << report;
        return result && *result ? **result : PenSample();
    }

    // Returns a report with X = 100 mm, Y = 75 mm from the near edge, pressure 1023, tilts 0.
    static std::string with_flags(std::string const& flags)
    {
        return "02 " + flags + " 10 27 c4 09 ff 03 00 00";
    }

    static constexpr char const* kOut = "02 00 00 00 00 00 00 00 00 00";

    std::unique_ptr<PenDecoder> decoder_ = *make_pen_decoder(simple_pen());
    Timestamp time_ {};
};

TEST_F(PenDecoderTest, ReadsPositionPressureAndTilt)
{
    auto const pen = sample("02 21 10 27 c4 09 ff 03 1e e2");
    EXPECT_NEAR(pen.position_mm.x(), 100.0, 1e-9);
    // The report has 2500 of 10000 counts from the far edge.
    EXPECT_NEAR(pen.position_mm.y(), 75.0, 1e-9);
    EXPECT_NEAR(pen.pressure.value(), 1023.0 / 2047, 1e-12);
    EXPECT_NEAR(pen.tilt_rad.value().x(), radians(30.0), 1e-12);
    EXPECT_NEAR(pen.tilt_rad.value().y(), radians(30.0),
                1e-12); // The report counts towards the user.
    EXPECT_TRUE(pen.in_range);
    EXPECT_TRUE(pen.touching);
    EXPECT_FALSE(pen.eraser);
    EXPECT_EQ(pen.time, time_);
    EXPECT_EQ(pen.raw_x, 10000);
    EXPECT_EQ(pen.raw_y, 2500);
    EXPECT_EQ(pen.raw_pressure, 1023);
}

TEST_F(PenDecoderTest, TellsWhatThePenCanSay)
{
    auto const& traits = decoder_->traits();
    EXPECT_NEAR(traits.size_mm.x(), 200, 1e-9);
    EXPECT_FALSE(traits.is_size_assumed);
    EXPECT_TRUE(traits.has_pressure && traits.has_tilt && traits.has_in_range && traits.has_eraser);
    EXPECT_EQ(traits.button_count, 2u);
    EXPECT_EQ(traits.raw_x_maximum, 20000);
    EXPECT_EQ(traits.raw_y_maximum, 10000);
    EXPECT_EQ(traits.raw_pressure_maximum, 2047);
}

TEST_F(PenDecoderTest, FollowsHoverTouchHoverLeave)
{
    EXPECT_FALSE(sample(with_flags("20")).touching);
    EXPECT_TRUE(sample(with_flags("21")).touching);
    EXPECT_FALSE(sample(with_flags("20")).touching);
    EXPECT_FALSE(sample(kOut).in_range);
}

TEST_F(PenDecoderTest, EndsAStrokeThatLeavesWithoutHovering)
{
    EXPECT_TRUE(sample(with_flags("21")).touching);
    auto const gone = sample(kOut);
    EXPECT_FALSE(gone.touching);
    EXPECT_FALSE(gone.in_range);
}

TEST_F(PenDecoderTest, TakesATouchForInRange)
{
    auto const pen = sample(with_flags("01"));
    EXPECT_TRUE(pen.in_range);
    EXPECT_TRUE(pen.touching);
}

TEST_F(PenDecoderTest, KeepsThePlaceOfAPenThatLeaves)
{
    sample("02 27 10 27 c4 09 ff 03 1e e2");
    auto const gone = sample(kOut); // A report of zeros.
    EXPECT_NEAR(gone.position_mm.x(), 100.0, 1e-9);
    EXPECT_NEAR(gone.position_mm.y(), 75.0, 1e-9);
    EXPECT_NEAR(gone.tilt_rad.value().x(), radians(30.0), 1e-12);
    EXPECT_EQ(gone.pressure, 0.0);
    EXPECT_EQ(gone.buttons, 0u);
}

TEST_F(PenDecoderTest, SaysNothingWhileThePenIsAway)
{
    EXPECT_EQ(decode(kOut).value(), std::nullopt);
    sample(with_flags("20"));
    sample(kOut);
    EXPECT_EQ(decode(kOut).value(), std::nullopt);
    EXPECT_TRUE(sample(with_flags("20")).in_range);
}

TEST_F(PenDecoderTest, ErasesWithEitherWayOfSayingSo)
{
    auto const eraser = sample(with_flags("30")); // The flag "eraser", without "invert" or "tip".
    EXPECT_TRUE(eraser.eraser && eraser.touching);
    auto const inverted = sample(with_flags("29")); // The flags "invert" and "tip".
    EXPECT_TRUE(inverted.eraser && inverted.touching);
    auto const hovering = sample(with_flags("28")); // The flag "invert" alone.
    EXPECT_TRUE(hovering.eraser && hovering.in_range);
    EXPECT_FALSE(hovering.touching);
}

TEST_F(PenDecoderTest, LetsOneToolLeaveBeforeTheOtherComes)
{
    EXPECT_FALSE(sample(with_flags("21")).eraser);
    auto const tip_leaves = sample(with_flags("30"));
    EXPECT_FALSE(tip_leaves.eraser);
    EXPECT_FALSE(tip_leaves.in_range);
    auto const eraser_comes = sample(with_flags("30"));
    EXPECT_TRUE(eraser_comes.eraser && eraser_comes.touching);
}

TEST_F(PenDecoderTest, SurvivesAWobbleBetweenTheTools)
{
    bool was_in_range = false;
    bool was_eraser = false;
    for (int i = 0; i < 20; ++i) {
        auto const pen = sample(with_flags(i % 2 ? "30" : "21"));
        EXPECT_FALSE(was_in_range && pen.in_range && pen.eraser != was_eraser);
        was_in_range = pen.in_range;
        was_eraser = pen.eraser;
    }
    sample(with_flags("21"));
    EXPECT_TRUE(sample(with_flags("21")).touching); // The tip can touch again after the eraser.
}

TEST_F(PenDecoderTest, ReportsBarrelButtonsWithoutMovingThePen)
{
    auto const before = sample(with_flags("20"));
    EXPECT_EQ(sample(with_flags("22")).buttons, 1u);
    EXPECT_EQ(sample(with_flags("24")).buttons, 2u);
    auto const both = sample(with_flags("27"));
    EXPECT_EQ(both.buttons, 3u);
    EXPECT_TRUE(both.touching);
    EXPECT_EQ(both.position_mm, before.position_mm);
    EXPECT_EQ(both.pressure, before.pressure);
    EXPECT_EQ(sample(with_flags("21")).buttons, 0u);
}

TEST_F(PenDecoderTest, PassesOverOtherReports)
{
    sample(with_flags("21"));
    EXPECT_EQ(decode("03 64").value(), std::nullopt); // A report of the battery.
    EXPECT_TRUE(sample(with_flags("21")).touching);
}

TEST_F(PenDecoderTest, BlamesTheDeviceForAShortReport)
{
    auto const result = decode("02 21 10 27");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Device);
    EXPECT_EQ(result.error().message, "pen report 2: 4 bytes, expected 10");
}

TEST_F(PenDecoderTest, BlamesTheDeviceForAReportThatItDoesNotDescribe)
{
    auto const unknown = decode("07 21 10 27 c4 09 ff 03 1e e2");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().fault, Fault::Device);
    EXPECT_EQ(unknown.error().message, "report 7 is not in the report descriptor");
    EXPECT_EQ(decode("").error().message, "an empty report");
}

TEST_F(PenDecoderTest, GoesOnAfterAShortReport)
{
    sample(with_flags("21"));
    EXPECT_FALSE(decode("02 21"));
    EXPECT_TRUE(sample(with_flags("21")).touching);
}

TEST_F(PenDecoderTest, AcceptsALongerReport)
{
    EXPECT_TRUE(sample(with_flags("21") + " 00 00").touching);
}

TEST_F(PenDecoderTest, BoundsThePressure)
{
    // Pressure of 65535, where the maximum is 2047.
    EXPECT_EQ(sample("02 21 10 27 c4 09 ff ff 00 00").pressure, 1.0);
}

TEST(PenDecoder, KeepsItsPlaceWhereTheDeviceSaysNull)
{
    auto info = simple_pen();
    // Declares that X and Y have a null state: Input (Data, Variable, Absolute, Null state).
    for (std::size_t i = 0; i + 1 < info.report_descriptor.size(); ++i)
        if (info.report_descriptor[i] == std::byte { 0x81 }
            && info.report_descriptor[i + 1] == std::byte { 0x02 })
            info.report_descriptor[i + 1] = std::byte { 0x42 };
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    auto const null = bytes("02 20 ff ff ff ff 00 00 00 00");
    EXPECT_EQ(decode_one(**decoder, {}, null).value(), std::nullopt);
    (void)decode_one(**decoder, {}, bytes("02 20 10 27 c4 09 00 00 00 00"));
    auto const pen = decode_one(**decoder, {}, null);
    ASSERT_TRUE(pen && *pen);
    EXPECT_NEAR((*pen)->position_mm.x(), 100.0, 1e-9);
}

TEST(PenDecoder, ReadsAMouseWithPressure)
{
    DeviceInfo const info {
        .report_descriptor = bytes(
            "05 01 09 02 a1 01 85 01 09 01 a1 00 05 09 19 01 29 03 15 00 25 01 95 03 75 01 81 02"
            "95 05 81 01 05 01 09 30 09 31 26 ff 7f 95 02 75 10 81 02"
            "05 0d 09 30 26 ff 1f 95 01 81 02 c0 c0")
    };
    auto decoder = make_pen_decoder(info);
    ASSERT_TRUE(decoder);
    EXPECT_FALSE((*decoder)->traits().has_in_range);
    auto const pen = decode_one(**decoder, {}, bytes("01 03 51 3b d7 13 ff 1f"));
    ASSERT_TRUE(pen && *pen);
    EXPECT_EQ((*pen)->raw_x, 0x3b51);
    EXPECT_TRUE((*pen)->touching && (*pen)->in_range);
    EXPECT_EQ((*pen)->buttons, 1u);
    EXPECT_EQ((*pen)->pressure, 1.0);
    EXPECT_FALSE((*pen)->tilt_rad);
}

TEST(PenDecoder, ExplainsWhyADeviceIsNoPen)
{
    auto const sensor = make_pen_decoder(simple_height_sensor());
    ASSERT_FALSE(sensor);
    EXPECT_EQ(sensor.error().message,
              "Height Sensor (1209:0001) is not a pen that describes itself: its report "
              "descriptor has no X, Y and tip of a pen");

    DeviceInfo const vendor { .name = "Newcomer",
                              .vendor_id = 0x256c,
                              // A product that is not in the table of tablets.
                              .product_id = 0xffff,
                              .report_descriptor
                              = bytes("06 00 ff 09 01 a1 01 85 08 75 58 95 01 09 01 81 02 c0") };
    auto const secret = make_pen_decoder(vendor);
    ASSERT_FALSE(secret);
    EXPECT_EQ(secret.error().message,
              "Newcomer (256c:ffff) is not a pen that describes itself: its report descriptor has "
              "reports in its maker's own format, and no X, Y and tip of a pen");
}

TEST(PenDecoder, BlamesTheDeviceForABrokenDescriptor)
{
    auto const result = make_pen_decoder({ .name = "Broken" });
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::Device);
    EXPECT_EQ(result.error().message, "Broken (0000:0000): the report descriptor is empty");
}

} // namespace
} // namespace tractus::drivers
