#include "drivers/sensors/hid_slider_decoder.h"

#include "tests/drivers/devices.h"
#include "tests/drivers/heights.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

TEST(HidSliderDecoder, ReadsCounts)
{
    auto const decoder = make_hid_slider_decoder(simple_height_sensor());
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_EQ((*decoder)->full_scale(), 4095);
    auto const heights = decode_heights(**decoder, timestamp_ns(7), bytes("01 34 02"));
    ASSERT_TRUE(heights);
    ASSERT_EQ(heights->size(), 1u);
    EXPECT_EQ(heights->front().time, timestamp_ns(7));
    EXPECT_EQ(heights->front().counts, 0x234);
    EXPECT_EQ(heights->front().full_scale, 4095);
}

TEST(HidSliderDecoder, PassesOverOtherReports)
{
    auto const decoder = make_hid_slider_decoder(simple_height_sensor()).value();
    EXPECT_TRUE(decode_heights(*decoder, {}, bytes("02 34 02")).value().empty());
    EXPECT_TRUE(decode_heights(*decoder, {}, {}).value().empty());
}

TEST(HidSliderDecoder, BlamesTheDeviceForAShortReport)
{
    auto const decoder = make_hid_slider_decoder(simple_height_sensor()).value();
    auto const height = decode_heights(*decoder, {}, bytes("01 34"));
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().fault, Fault::Device);
    EXPECT_EQ(height.error().message, "height report 1: 2 bytes, expected 3");
}

TEST(HidSliderDecoder, BlamesTheDeviceForMoreThanFullScale)
{
    auto const decoder = make_hid_slider_decoder(simple_height_sensor()).value();
    auto const height = decode_heights(*decoder, {}, bytes("01 00 10"));
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().message, "height report 1: 4096 counts, expected 0 to 4095");
}

TEST(HidSliderDecoder, TakesNoPenForASensor)
{
    auto const decoder = make_hid_slider_decoder(simple_pen());
    ASSERT_FALSE(decoder);
    EXPECT_EQ(decoder.error().message,
              "Simple Pen (1209:0002) is not a height sensor: its report descriptor has no "
              "absolute slider from 0 to full scale");
}

TEST(HidSliderDecoder, TakesNoJoysticksThrottleForASensor)
{
    DeviceInfo const joystick {
        .report_descriptor = bytes("05 01 09 04 a1 01 09 36 15 00 26 ff 0f 75 10 95 01 81 02 c0")
    };
    EXPECT_FALSE(make_hid_slider_decoder(joystick));
}

} // namespace
} // namespace tractus::drivers
