#include "calib/pressure_response.h"

#include "calib/fuser.h"

#include <gtest/gtest.h>
#include <vector>

namespace tractus::calib {
namespace {

TEST(PressureResponse, IsTheDevicesOwnByDefault)
{
    for (double const pressure : { 0.0, 0.1, 1.0 / 3, 1.0 })
        EXPECT_EQ(respond({}, pressure), pressure);
}

TEST(PressureResponse, GrowsFromTheThresholdToFullPressure)
{
    PressureResponse const response { .threshold = 0.1, .full = 0.6 };
    EXPECT_EQ(respond(response, 0.05), 0);
    EXPECT_EQ(respond(response, 0.1), 0);
    EXPECT_NEAR(respond(response, 0.35), 0.5, 1e-12);
    EXPECT_EQ(respond(response, 0.6), 1);
    EXPECT_EQ(respond(response, 0.9), 1);
}

TEST(PressureResponse, BendsWithItsExponent)
{
    EXPECT_NEAR(respond({ .exponent = 2 }, 0.5), 0.25, 1e-12);
    EXPECT_NEAR(respond({ .exponent = 0.5 }, 0.25), 0.5, 1e-12);
}

// Returns the tips that a fuser makes from a pen, touching or not, with these pressures.
std::vector<TipSample> tips(PressureResponse const& response, std::vector<double> const& pressures,
                            bool touching = true)
{
    Fuser fuser({ .pressure = response }, ScriptedHeight {});
    for (double const pressure : pressures)
        (void)fuser.push(
            drivers::PenSample { .pressure = pressure, .in_range = true, .touching = touching });
    return fuser.take_settled();
}

std::vector<bool> touches(std::vector<TipSample> const& tips)
{
    std::vector<bool> result;
    for (auto const& tip : tips)
        result.push_back(tip.touching);
    return result;
}

TEST(PressureResponse, DrawsAboveTheThresholdUntilHalfOfIt)
{
    EXPECT_EQ(touches(tips({ .threshold = 0.1 }, { 0.05, 0.09, 0.11, 0.09, 0.06, 0.04, 0.09 })),
              (std::vector<bool> { false, false, true, true, true, false, false }));
}

TEST(PressureResponse, StrokesBeginAndEndThin)
{
    for (auto const& tip : tips({ .threshold = 0.1 }, { 0.08, 0.1, 0.09 }))
        EXPECT_EQ(tip.pressure, 0);
}

TEST(PressureResponse, DrawsNothingWhileThePenHovers)
{
    EXPECT_EQ(touches(tips({ .threshold = 0.1 }, { 0.5, 0.5 }, false)),
              (std::vector<bool> { false, false }));
}

TEST(PressureResponse, LeavesPensWithoutPressureAlone)
{
    Fuser fuser({ .pressure = { .threshold = 0.5 } }, ScriptedHeight {});
    auto const tip = fuser.push(drivers::PenSample { .in_range = true, .touching = true });
    ASSERT_TRUE(tip);
    EXPECT_TRUE(tip->touching);
    EXPECT_EQ(tip->pressure, 1);
}

} // namespace
} // namespace tractus::calib
