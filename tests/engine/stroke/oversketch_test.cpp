#include "engine/stroke/oversketch.h"

#include "engine/stroke/polyline.h"
#include "tests/engine/stroke/strokes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus {
namespace {

// Returns a vertical stroke of 100 mm, with a tip every 2 mm.
Stroke upright()
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 50; ++i)
        points.push_back({ 0, 0, 2.0 * i });
    return stroke_of(points);
}

// Returns a stroke that bulges to the right between two heights. Its ends are `gap_mm` beside the
// vertical stroke.
Stroke bulge(double from_mm, double to_mm, double gap_mm = 0)
{
    std::vector<Vec3> points;
    for (int i = 0; i <= 20; ++i) {
        double const share = i / 20.0;
        points.push_back(
            { gap_mm + 30 * std::sin(kPi * share), 0, from_mm + share * (to_mm - from_mm) });
    }
    return stroke_of(points);
}

void expect_time_order(Stroke const& stroke)
{
    for (std::size_t i = 1; i < stroke.tips.size(); ++i)
        EXPECT_GT(stroke.tips[i].time, stroke.tips[i - 1].time);
}

double widest(Stroke const& stroke)
{
    double x = 0;
    for (auto const& tip : stroke.tips)
        x = std::max(x, tip.position_mm.x());
    return x;
}

TEST(Oversketch, TakesThePlaceOfWhatLiesBetweenItsEnds)
{
    for (bool const downwards : { false, true }) {
        auto const over = downwards ? bulge(60, 40) : bulge(40, 60);
        auto const redrawn = oversketch(upright(), over);
        ASSERT_TRUE(redrawn) << redrawn.error().message;
        expect_time_order(*redrawn);
        EXPECT_EQ(redrawn->tips.front().position_mm, Vec3(0, 0, 0));
        EXPECT_EQ(redrawn->tips.back().position_mm, Vec3(0, 0, 100));
        EXPECT_NEAR(widest(*redrawn), 30, 1e-9);
        for (std::size_t i = 1; i < redrawn->tips.size(); ++i)
            EXPECT_GT(redrawn->tips[i].position_mm.z(), redrawn->tips[i - 1].position_mm.z());
        for (auto const& tip : redrawn->tips)
            if (tip.position_mm.z() < 39 || tip.position_mm.z() > 61) {
                EXPECT_EQ(tip.position_mm.x(), 0);
            }
    }
}

TEST(Oversketch, JoinsWithoutAGap)
{
    auto const redrawn = oversketch(upright(), bulge(40, 60, 8)).value();
    for (std::size_t i = 1; i < redrawn.tips.size(); ++i)
        EXPECT_LT((redrawn.tips[i].position_mm - redrawn.tips[i - 1].position_mm).norm(), 6);
}

TEST(Oversketch, RedrawsTheRestFromWhereItLeaves)
{
    auto const redrawn
        = oversketch(upright(), stroke_of({ { 1, 0, 50 }, { 30, 0, 60 }, { 80, 0, 60 } })).value();
    expect_time_order(redrawn);
    EXPECT_EQ(redrawn.tips.front().position_mm, Vec3(0, 0, 0));
    EXPECT_EQ(redrawn.tips.back().position_mm, Vec3(80, 0, 60));
}

TEST(Oversketch, RedrawsTheBeginningUpToWhereItArrives)
{
    auto const redrawn
        = oversketch(upright(), stroke_of({ { 80, 0, 0 }, { 40, 0, 20 }, { 1, 0, 50 } })).value();
    expect_time_order(redrawn);
    EXPECT_EQ(redrawn.tips.front().position_mm, Vec3(80, 0, 0));
    EXPECT_EQ(redrawn.tips.back().position_mm, Vec3(0, 0, 100));
}

TEST(Oversketch, RefusesALineBesideTheStroke)
{
    EXPECT_EQ(oversketch(upright(), stroke_of({ { 70, 0, 50 }, { 70, 0, 60 } })).error().message,
              "the new line begins and ends 70 mm or more beside the stroke that it should redraw: "
              "begin or end it on the stroke");
    EXPECT_FALSE(oversketch(upright(), stroke_of({ { 0, 0, 50 } })));
    EXPECT_FALSE(oversketch({}, bulge(40, 60)));
}

} // namespace
} // namespace tractus
