#include "drivers/sensors/sensor_volts.h"

#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

TEST(SensorVolts, AreReadFromWhatWasPrinted)
{
    auto const name = "LabJack U3-LV 320, AIN0, " + print_volts_per_count(3.7231e-5, -0.01);
    EXPECT_NEAR(sensor_volts(name, 0).value(), -0.01, 1e-9);
    EXPECT_NEAR(sensor_volts(name, 10'000).value(), 0.36231, 1e-9);
    EXPECT_NEAR(sensor_volts(print_volts_per_count(0.002, 0), 512).value(), 1.024, 1e-9);
}

TEST(SensorVolts, AreNotKnownOfAnotherName)
{
    EXPECT_EQ(sensor_volts("MCP2221, GP1", 100), std::nullopt);
    EXPECT_EQ(sensor_volts("1 V per count from ", 100), std::nullopt);
    EXPECT_EQ(sensor_volts("some V per count from 0 V", 100), std::nullopt);
    EXPECT_EQ(sensor_volts("", 100), std::nullopt);
}

} // namespace
} // namespace tractus::drivers
