#include "sim/height_curve.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::sim {

namespace {

// Log of the sensor of firmware-notes/height-sensor.md: 0, then half, then full scale, 10 ms apart.
constexpr auto kLog = "R: 22 05 01 09 08 a1 01 85 01 09 36 15 00 26 ff 0f 75 10 95 01 81 02 c0\n"
                      "N: Height\n"
                      "I: 3 1209 0001\n"
                      "E: 000005.000000 3 01 00 00\n"
                      "E: 000005.010000 3 01 00 08\n"
                      "E: 000005.020000 3 01 ff 0f\n";

Timestamp at_ms(int ms)
{
    return Timestamp(std::chrono::milliseconds(ms));
}

Result<HeightCurve> read(std::string const& text)
{
    return HeightCurve::read(drivers::parse_log(text, "test").value());
}

} // namespace

TEST(HeightCurve, GoesStraightFromReadingToReading)
{
    auto const curve = read(kLog);
    ASSERT_TRUE(curve) << curve.error().message;
    EXPECT_EQ(curve->full_scale(), 4095);
    EXPECT_NEAR(curve->fraction_at(at_ms(5)), 0.25, 0.001);
    EXPECT_NEAR(curve->fraction_at(at_ms(10)), 2048 / 4095.0, 1e-9);
    EXPECT_NEAR(curve->fraction_at(at_ms(15)), 0.75, 0.001);
}

TEST(HeightCurve, StandsStillBeforeAndAfter)
{
    auto const curve = read(kLog);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->fraction_at(at_ms(-100)), 0);
    EXPECT_EQ(curve->fraction_at(at_ms(500)), 1);
    EXPECT_EQ(curve->end(), at_ms(20));
}

TEST(HeightCurve, AsksAnotherConverter)
{
    auto const curve = read(kLog);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->counts_at(at_ms(20), 1023), 1023);
    EXPECT_EQ(curve->counts_at(at_ms(10), 1023), 512);
}

TEST(HeightCurve, NeedsAHeightSensor)
{
    auto const curve = read("R: 3 05 0d c0\nN: No\nE: 000000.000000 1 00\n");
    ASSERT_FALSE(curve);
    EXPECT_EQ(curve.error().fault, Fault::User);
    EXPECT_NE(curve.error().message.find("no heights to play"), std::string::npos);
}

} // namespace tractus::sim
