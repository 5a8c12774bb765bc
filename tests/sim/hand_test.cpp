#include "sim/hand.h"

#include "tests/sim/fused_run.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::sim {
namespace {

using namespace std::chrono_literals;

HandStroke line(Vec3 const& from_mm, Vec3 const& to_mm, double speed_mm_s)
{
    return { .path = make_path(LineShape { from_mm, to_mm }), .speed_mm_s = speed_mm_s };
}

HandOptions const kSteady { .plane_tremor_mm = 0, .height_tremor_mm = 0 };

TEST(SpeedProfile, GoesFromRestToRest)
{
    for (double const length_mm : { 0.1, 10.0, 49.9, 50.1, 1000.0 }) {
        SpeedProfile const profile(length_mm, 200);
        auto const end_s = profile.duration_s();
        EXPECT_NEAR(profile.distance_mm(0), 0, 1e-9);
        EXPECT_NEAR(profile.distance_mm(end_s), length_mm, 1e-9);
        EXPECT_NEAR(profile.distance_mm(end_s / 2), length_mm / 2, 1e-9);
        EXPECT_NEAR(profile.speed_mm_s(0), 0, 1e-9);
        EXPECT_NEAR(profile.speed_mm_s(end_s), 0, 1e-9);
    }
}

TEST(SpeedProfile, SpeedIsTheDistancesSlope)
{
    for (double const length_mm : { 5.0, 300.0 }) {
        SpeedProfile const profile(length_mm, 200);
        constexpr double kStep_s = 1e-5;
        for (double t = kStep_s; t < profile.duration_s() - kStep_s; t += 0.003) {
            double const slope
                = (profile.distance_mm(t + kStep_s) - profile.distance_mm(t - kStep_s))
                / (2 * kStep_s);
            ASSERT_NEAR(profile.speed_mm_s(t), slope, 1e-3) << length_mm << " mm at " << t << " s";
        }
    }
}

TEST(SpeedProfile, CruisesOnALongWayAlone)
{
    SpeedProfile const longer(1000, 200);
    EXPECT_DOUBLE_EQ(longer.speed_mm_s(longer.duration_s() / 2), 200);
    SpeedProfile const shorter(5, 200);
    EXPECT_LT(shorter.speed_mm_s(shorter.duration_s() / 2), 50);
    EXPECT_GT(shorter.duration_s(), 0.2);
}

TEST(Hand, DrawsFromStartToEndOfItsPath)
{
    Hand const hand({ line({ -50, 0, 10 }, { 50, 20, 10 }, 150) }, kSteady);
    ASSERT_EQ(hand.strokes().size(), 1u);
    auto const [chosen, down, up] = hand.strokes()[0];
    EXPECT_LT(chosen, down);
    EXPECT_LT((hand.at(down).position_mm - Vec3(-50, 0, 10)).norm(), 1e-6);
    EXPECT_LT((hand.at(up).position_mm - Vec3(50, 20, 10)).norm(), 1e-6);
    EXPECT_FALSE(hand.at(down - 1ms).touching);
    EXPECT_TRUE(hand.at(down + 1ms).touching);
    EXPECT_TRUE(hand.at(up - 1ms).touching);
    EXPECT_FALSE(hand.at(up + 1ms).touching);
}

TEST(Hand, StaysOnItsPath)
{
    auto const shape
        = HelixShape { .radius_mm = 40, .end_radius_mm = 40, .turns = 2, .rise_mm = 80 };
    Hand const hand({ { .path = make_path(shape), .speed_mm_s = 200 } }, kSteady);
    for (auto t = hand.strokes()[0].down; t < hand.strokes()[0].up; t += 10ms)
        ASSERT_NEAR(hand.at(t).position_mm.head<2>().norm(), 40, 0.01);
}

TEST(Hand, KeepsBothSpeedLimitsAndReachesThem)
{
    auto const hand = fast_hand(1);
    double plane_mm_s = 0;
    double height_mm_s = 0;
    auto const [chosen, down, up] = hand.strokes()[0]; // The first stroke is the rising helix.
    for (auto t = Timestamp {}; t < hand.end(); t += 1ms) {
        auto const velocity = hand.at(t).velocity_mm_s;
        plane_mm_s = std::max(plane_mm_s, velocity.head<2>().norm());
        height_mm_s = std::max(height_mm_s, std::abs(velocity.z()));
    }
    // The tolerance allows for the tremor.
    EXPECT_NEAR(plane_mm_s, 300, 30);
    EXPECT_NEAR(height_mm_s, 200, 12);
    auto const middle = hand.at(down + (up - down) / 2).velocity_mm_s;
    EXPECT_NEAR(middle.head<2>().norm(), 300, 25);
    EXPECT_NEAR(middle.z(), 200, 12);
}

TEST(Hand, VelocityIsThePositionsSlope)
{
    auto const hand = fast_hand(3);
    for (auto t = Timestamp { 1ms }; t < hand.end(); t += 13ms) {
        Vec3 const slope = (hand.at(t + 10us).position_mm - hand.at(t - 10us).position_mm) / 20e-6;
        // A helix is piecewise linear, so the direction changes slightly between pieces.
        ASSERT_LT((hand.at(t).velocity_mm_s - slope).norm(), 10) << to_seconds(t);
    }
}

TEST(Hand, TremblesAFewTenthsOfAMillimetre)
{
    auto const stroke = line({ 0, 0, 10 }, { 100, 0, 10 }, 50);
    Hand const trembling({ stroke }, { .plane_tremor_mm = 0.2, .height_tremor_mm = 0.1 });
    Hand const steady({ stroke }, kSteady);
    Vec3 sum_of_squares = Vec3::Zero();
    int count = 0;
    for (auto t = Timestamp {}; t < steady.end(); t += 1ms, ++count)
        sum_of_squares += (trembling.at(t).position_mm - steady.at(t).position_mm).cwiseAbs2();
    Vec3 const deviation_mm = (sum_of_squares / count).cwiseSqrt();
    EXPECT_NEAR(deviation_mm.x(), 0.2, 0.05);
    EXPECT_NEAR(deviation_mm.y(), 0.2, 0.05);
    EXPECT_NEAR(deviation_mm.z(), 0.1, 0.025);
}

TEST(Hand, PressesLightlyAtBothEnds)
{
    Hand const hand({ line({ 0, 0, 10 }, { 100, 0, 10 }, 100) }, {});
    auto const [chosen, down, up] = hand.strokes()[0];
    EXPECT_LT(hand.at(down + 1ms).pressure, 0.05);
    EXPECT_LT(hand.at(up - 1ms).pressure, 0.05);
    EXPECT_NEAR(hand.at(down + (up - down) / 2).pressure, 0.6, 0.1);
    EXPECT_EQ(hand.at(down - 1ms).pressure, 0);
}

TEST(Hand, LeavesTheTabletOnItsWayToAFarStroke)
{
    Hand const hand({ line({ -100, 0, 10 }, { -50, 0, 10 }, 100),
                      line({ 100, 0, 200 }, { 100, 50, 200 }, 100),
                      line({ 99, 50, 200 }, { 90, 50, 200 }, 100) },
                    {});
    EXPECT_FALSE(hand.at(Timestamp {}).in_range);
    EXPECT_FALSE(hand.at(hand.strokes()[1].chosen).in_range);
    EXPECT_TRUE(hand.at(hand.strokes()[1].down - 1ms).in_range);
    EXPECT_TRUE(hand.at(hand.strokes()[2].chosen).in_range);
    EXPECT_FALSE(hand.at(hand.end()).in_range);
}

TEST(Hand, DrawsStrokesFromTheSamePlace)
{
    auto const there = line({ 0, 0, 10 }, { 50, 0, 10 }, 100);
    auto const back = line({ 50, 0, 10 }, { 0, 0, 10 }, 100);
    Hand const hand({ there, back }, kSteady);
    EXPECT_LE(hand.strokes()[0].up, hand.strokes()[1].chosen);
    EXPECT_LT(hand.strokes()[1].chosen, hand.strokes()[1].down);
}

} // namespace
} // namespace tractus::sim
