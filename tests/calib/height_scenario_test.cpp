#include "calib/height_scenario.h"

#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

double height_of(std::string_view name, Duration since_first, Duration length)
{
    return height_mm(parse_height_scenario(name).value(), since_first, length);
}

TEST(HeightScenario, ReadsANumberOfMillimetres)
{
    EXPECT_EQ(height_of("120", 3s, 10s), 120);
    EXPECT_EQ(height_of("-2.5", 0s, 0s), -2.5);
}

TEST(HeightScenario, RiseAndFallTakeTheWholeLog)
{
    EXPECT_DOUBLE_EQ(height_of("rise", 0s, 10s), 50);
    EXPECT_DOUBLE_EQ(height_of("rise", 5s, 10s), 200);
    EXPECT_DOUBLE_EQ(height_of("rise", 10s, 10s), 350);
    EXPECT_DOUBLE_EQ(height_of("fall", 2s, 10s), 290);
}

TEST(HeightScenario, ArchComesBack)
{
    EXPECT_NEAR(height_of("arch", 0s, 10s), 50, 1e-9);
    EXPECT_NEAR(height_of("arch", 5s, 10s), 350, 1e-9);
    EXPECT_NEAR(height_of("arch", 10s, 10s), 50, 1e-9);
}

TEST(HeightScenario, SwayDoesNotDependOnTheLogsLength)
{
    EXPECT_NEAR(height_of("sway", 2s, 10s), 350, 1e-9);
    EXPECT_NEAR(height_of("sway", 2s, 100s), 350, 1e-9);
    EXPECT_NEAR(height_of("sway", 6s, 10s), 50, 1e-9);
}

TEST(HeightScenario, HoldsBeforeAndAfterTheLog)
{
    EXPECT_DOUBLE_EQ(height_of("rise", -1s, 10s), 50);
    EXPECT_DOUBLE_EQ(height_of("rise", 11s, 10s), 350);
    EXPECT_DOUBLE_EQ(height_of("rise", 1s, 0s), 50);
}

TEST(HeightScenario, SaysWhichHeightsThereAre)
{
    for (auto const* text : { "", "up", "12mm", "nan", "inf", "1e999" }) {
        auto const scenario = parse_height_scenario(text);
        ASSERT_FALSE(scenario) << text;
        EXPECT_EQ(scenario.error().fault, Fault::User);
        EXPECT_EQ(scenario.error().message,
                  "unknown height \"" + std::string(text)
                      + "\": give millimetres, rise, fall, arch or sway");
    }
}

} // namespace
} // namespace tractus::calib
