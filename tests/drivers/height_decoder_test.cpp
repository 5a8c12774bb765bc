#include "drivers/height_decoder.h"

#include "tests/drivers/devices.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(HeightDecoder, ReadsCounts)
{
    auto const decoder = HeightDecoder::create(simple_height_sensor());
    ASSERT_TRUE(decoder) << decoder.error().message;
    EXPECT_EQ(decoder->full_scale(), 4095);
    auto const height = decoder->decode(timestamp_ns(7), bytes("01 34 02"));
    ASSERT_TRUE(height && *height);
    EXPECT_EQ((*height)->time, timestamp_ns(7));
    EXPECT_EQ((*height)->counts, 0x234);
    EXPECT_EQ((*height)->full_scale, 4095);
}

TEST(HeightDecoder, PassesOverOtherReports)
{
    auto const decoder = HeightDecoder::create(simple_height_sensor());
    EXPECT_EQ(decoder->decode({}, bytes("02 34 02")).value(), std::nullopt);
    EXPECT_EQ(decoder->decode({}, {}).value(), std::nullopt);
}

TEST(HeightDecoder, BlamesTheDeviceForAShortReport)
{
    auto const height = HeightDecoder::create(simple_height_sensor())->decode({}, bytes("01 34"));
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().fault, Fault::Device);
    EXPECT_EQ(height.error().message, "height report 1: 2 bytes, expected 3");
}

TEST(HeightDecoder, BlamesTheDeviceForMoreThanFullScale)
{
    auto const height
        = HeightDecoder::create(simple_height_sensor())->decode({}, bytes("01 00 10"));
    ASSERT_FALSE(height);
    EXPECT_EQ(height.error().message, "height report 1: 4096 counts, expected 0 to 4095");
}

TEST(HeightDecoder, TakesNoPenForASensor)
{
    auto const decoder = HeightDecoder::create(simple_pen());
    ASSERT_FALSE(decoder);
    EXPECT_EQ(decoder.error().message,
              "Simple Pen (1209:0002) is not a height sensor: its report descriptor has no "
              "absolute slider from 0 to full scale");
}

TEST(HeightDecoder, TakesNoJoysticksThrottleForASensor)
{
    DeviceInfo const joystick {
        .report_descriptor = bytes("05 01 09 04 a1 01 09 36 15 00 26 ff 0f 75 10 95 01 81 02 c0")
    };
    EXPECT_FALSE(HeightDecoder::create(joystick));
}

} // namespace
} // namespace tractus
