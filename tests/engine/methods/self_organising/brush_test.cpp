#include "engine/methods/self_organising/brush.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <tuple>
#include <vector>

namespace tractus::self_organising {
namespace {

// Returns a sweep of a brush with a radius of 400 mm. In 6 s, the brush moves up and then to the
// side.
BrushSweep bent_sweep(int years = 14)
{
    BrushSweep sweep { .years = years, .seed = 7 };
    for (int i = 0; i <= 60; ++i)
        sweep.balls.push_back({ 0.05 * i, Vec3(0, 0, 30.0 * i), 400 });
    for (int i = 1; i <= 60; ++i)
        sweep.balls.push_back({ 3 + 0.05 * i, Vec3(25.0 * i, 0, 1800), 400 });
    return sweep;
}

using Places = std::multiset<std::tuple<double, double, double>>;

Places places_of(std::vector<Vec3> const& markers)
{
    Places places;
    for (auto const& marker : markers)
        places.insert({ marker.x(), marker.y(), marker.z() });
    return places;
}

double distance_to(BrushSweep const& sweep, Vec3 const& place)
{
    double least = 1e9;
    for (auto const& ball : sweep.balls)
        least = std::min(least, (ball.centre - place).norm() - ball.radius);
    return least;
}

TEST(BrushSowing, DoesNotDependOnTheWay)
{
    Habit const habit;
    auto sweep = bent_sweep();
    auto const markers = places_of(sow(sweep, habit).value());
    ASSERT_GT(markers.size(), 500U);
    auto there_and_back = sweep;
    for (auto ball = sweep.balls.rbegin(); ball != sweep.balls.rend(); ++ball)
        there_and_back.balls.push_back(*ball);
    EXPECT_EQ(places_of(sow(there_and_back, habit).value()), markers) << "nothing is sown twice";
    std::reverse(sweep.balls.begin(), sweep.balls.end());
    EXPECT_EQ(places_of(sow(sweep, habit).value()), markers);
    sweep.seed = 8;
    EXPECT_NE(places_of(sow(sweep, habit).value()), markers);
}

TEST(BrushSowing, FillsTheBallEvenly)
{
    Habit const habit { .internode_mm = 50 };
    BrushSweep const sweep { .balls = { { 0, Vec3(1000, -500, 3000), 900 } } };
    auto const markers = sow(sweep, habit).value();
    double const volume = 4.0 / 3 * kPi * std::pow(900.0 / 50, 3);
    // There is one marker in each volume of two cubed internodes.
    double const expected = volume / 2;
    EXPECT_NEAR(static_cast<double>(markers.size()), expected, 4 * std::sqrt(expected));
    Vec3 mean = Vec3::Zero();
    for (auto const& marker : markers) {
        mean += marker / static_cast<double>(markers.size());
        EXPECT_LT(distance_to(sweep, marker), 63);
    }
    EXPECT_LT((mean - sweep.balls[0].centre).norm(), 30);
}

TEST(BrushSowing, RefusesWhatNoMemoryHolds)
{
    Habit const habit { .internode_mm = 1 };
    auto const refusal = [&](double radius, double way) {
        BrushSweep const sweep { .balls = { { 0, Vec3::Zero(), radius },
                                            { 1, Vec3(way, 0, 0), radius } } };
        auto const sown = sow(sweep, habit);
        return sown ? std::string() : sown.error().message;
    };
    EXPECT_EQ(refusal(5, 10), "");
    EXPECT_NE(refusal(1e6, 1).find("sweeps over more than"), std::string::npos);
    EXPECT_NE(refusal(1, 1e300).find("sweeps over more than"), std::string::npos);
    EXPECT_NE(refusal(0, 1).find("has no radius"), std::string::npos);
    EXPECT_NE(refusal(std::nan(""), 1).find("has no radius"), std::string::npos);
}

TEST(BrushGrowth, StaysWhereTheBrushWas)
{
    Habit const habit;
    auto const sweep = bent_sweep(20);
    auto tree = plant_seed(Vec3::Zero());
    ASSERT_TRUE(grow_along(tree, sweep, habit, 1));
    EXPECT_EQ(tree.step, 20);
    EXPECT_GT(tree.size(), 100U);
    double farthest = 0;
    for (auto const& place : tree.places) {
        EXPECT_LT(distance_to(sweep, place.position), 4 * habit.internode_mm * habit.longest);
        farthest = std::max(farthest, place.position.x());
    }
    EXPECT_GT(farthest, 1000) << "the tree follows the brush aside";
}

TEST(BrushGrowth, WaitsOutsideTheBrush)
{
    Habit const habit;
    auto sweep = bent_sweep(20);
    sweep.balls.resize(61); // In the first half of the sweep, the brush moves upwards.
    for (int i = 0; i < 60; ++i)
        // In the second half of the sweep, the brush is far away.
        sweep.balls.push_back({ 3 + 0.05 * i, Vec3(0, 0, 1e5), 400 });
    auto tree = plant_seed(Vec3::Zero());
    ASSERT_TRUE(grow_along(tree, sweep, habit, 1));
    auto waiting = plant_seed(Vec3::Zero());
    sweep.waits_outside = true;
    ASSERT_TRUE(grow_along(waiting, sweep, habit, 1));
    auto const last = [](GrowingTree const& of) { return of.links.back().step; };
    EXPECT_GT(last(tree), 10);
    EXPECT_LE(last(waiting), 10) << "nothing grows once the brush is away";
}

TEST(BrushGrowth, AStrokeWithoutTimesGrowsByItsPoints)
{
    Habit const habit;
    auto sweep = bent_sweep(10);
    auto timeless = sweep;
    for (auto& ball : timeless.balls)
        ball.seconds = 0;
    auto tree = plant_seed(Vec3::Zero());
    auto other = plant_seed(Vec3::Zero());
    ASSERT_TRUE(grow_along(tree, sweep, habit, 1));
    ASSERT_TRUE(grow_along(other, timeless, habit, 1));
    EXPECT_EQ(other.step, 10);
    EXPECT_GT(other.size(), 50U);
}

} // namespace
} // namespace tractus::self_organising
