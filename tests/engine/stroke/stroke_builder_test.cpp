#include "engine/stroke/stroke_builder.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus {
namespace {

TipSample tip(int time_ms, double x_mm, bool touching = true)
{
    return { .time = timestamp_ns(time_ms * 1'000'000ll),
             .position_mm = { x_mm, 0, 0 },
             .pressure = touching ? 0.5 : 0,
             .touching = touching };
}

TEST(StrokeBuilder, EndsAStrokeWhereThePenIsLifted)
{
    StrokeBuilder builder;
    EXPECT_FALSE(builder.push(tip(0, 0, false)));
    EXPECT_FALSE(builder.push(tip(5, 1)));
    EXPECT_FALSE(builder.push(tip(10, 2)));
    auto const stroke = builder.push(tip(15, 3, false));
    ASSERT_TRUE(stroke);
    ASSERT_EQ(stroke->tips.size(), 2u);
    EXPECT_EQ(stroke->tips[0].position_mm.x(), 1);
    EXPECT_EQ(stroke->tips[1].position_mm.x(), 2);
}

TEST(StrokeBuilder, AGapEndsNoStroke)
{
    StrokeBuilder builder;
    (void)builder.push(tip(0, 0));
    (void)builder.push(tip(5, 1));
    EXPECT_FALSE(builder.push(tip(505, 2)));
    EXPECT_FALSE(builder.push(tip(60'505, 50))) << "a pen that rested for a minute";
    auto const stroke = builder.push(tip(60'510, 51, false));
    ASSERT_TRUE(stroke);
    EXPECT_EQ(stroke->tips.size(), 4u);
}

TEST(StrokeBuilder, ATapIsNoStroke)
{
    StrokeBuilder builder;
    (void)builder.push(tip(0, 7));
    (void)builder.push(tip(5, 7));
    EXPECT_FALSE(builder.push(tip(10, 8, false)));
    EXPECT_FALSE(builder.finish());
}

TEST(StrokeBuilder, InkShowsLiveTipsAtOnce)
{
    StrokeBuilder builder;
    builder.push_live(tip(5, 1));
    builder.push_live(tip(10, 2));
    EXPECT_EQ(builder.ink().size(), 2u);
}

TEST(StrokeBuilder, SettledTipsReplaceLiveOnes)
{
    StrokeBuilder builder;
    builder.push_live(tip(5, 1));
    builder.push_live(tip(10, 2));
    (void)builder.push(tip(5, 1.5));
    auto const ink = builder.ink();
    ASSERT_EQ(ink.size(), 2u);
    EXPECT_EQ(ink[0].position_mm.x(), 1.5);
    EXPECT_EQ(ink[1].position_mm.x(), 2);
}

TEST(StrokeBuilder, InkOfAStrokeGoesWhenItIsFinished)
{
    StrokeBuilder builder;
    for (auto const& each : { tip(5, 1), tip(10, 2), tip(15, 3, false), tip(20, 4, false) })
        builder.push_live(each);
    EXPECT_EQ(builder.ink().size(), 3u); // A single tip that does not touch must end the stroke.
    (void)builder.push(tip(5, 1));
    (void)builder.push(tip(10, 2));
    EXPECT_TRUE(builder.push(tip(15, 3, false)));
    EXPECT_TRUE(builder.ink().empty());
}

TEST(StrokeBuilder, InkIsPartedWhereThePenWasLifted)
{
    StrokeBuilder builder;
    (void)builder.push(tip(5, 1));
    (void)builder.push(tip(10, 2));
    for (auto const& each : { tip(15, 3, false), tip(20, 4, false), tip(25, 5) })
        builder.push_live(each);
    auto const ink = builder.ink();
    ASSERT_EQ(ink.size(), 4u);
    EXPECT_FALSE(ink[2].touching);
    EXPECT_TRUE(ink[3].touching);
}

TEST(StrokeBuilder, LiveTipsThatComeLateAreNotInkTwice)
{
    StrokeBuilder builder;
    (void)builder.push(tip(5, 1));
    builder.push_live(tip(5, 1));
    EXPECT_EQ(builder.ink().size(), 1u);
}

TEST(StrokeBuilder, IgnoresWhatIsOutOfOrderOrNotANumber)
{
    StrokeBuilder builder;
    (void)builder.push(tip(5, 1));
    (void)builder.push(tip(5, 9));
    (void)builder.push(tip(4, 9));
    (void)builder.push(tip(6, std::numeric_limits<double>::quiet_NaN()));
    (void)builder.push(tip(10, 2));
    auto const stroke = builder.finish();
    ASSERT_TRUE(stroke);
    EXPECT_EQ(stroke->tips.size(), 2u);
}

} // namespace
} // namespace tractus
