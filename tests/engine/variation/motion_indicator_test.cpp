#include "engine/variation/influence.h"

#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus::variation {
namespace {

Vec3 summed_influence(std::vector<MotionIndicator> const& indicators, double shown_height_mm)
{
    return influence_of({}, {}, indicators, { .height_mm = shown_height_mm }).value().everywhere;
}

TEST(MotionIndicator, TakesOnlyTheEndsOfTheStroke)
{
    auto const indicator
        = motion_indicator(stroke_of({ { 1, 2, 3 }, { 90, -50, 7 }, { 4, 5, 6 } }));
    ASSERT_TRUE(indicator);
    EXPECT_EQ(indicator->start_mm, Vec3(1, 2, 3));
    EXPECT_EQ(indicator->end_mm, Vec3(4, 5, 6));
}

TEST(MotionIndicator, TheSumIsWhatCounts)
{
    std::vector<MotionIndicator> const three { { { 0, 0, 0 }, { 100, 0, 0 } },
                                               { { 5, 5, 5 }, { 55, 5, 5 } },
                                               { { 0, 0, 9 }, { 0, 20, 9 } } };
    std::vector<MotionIndicator> const one { { { 7, 7, 7 }, { 157, 27, 7 } } };
    EXPECT_EQ(summed_influence(three, 200), summed_influence(one, 200));
    EXPECT_EQ(summed_influence(one, 200), Vec3(0.75, 0.1, 0));
}

TEST(MotionIndicator, OppositeOnesCancel)
{
    std::vector<MotionIndicator> const two { { { 0, 0, 0 }, { 100, 20, 30 } },
                                             { { 105, 25, 30 }, { 5, 5, 0 } } };
    EXPECT_EQ(summed_influence(two, 200), Vec3(0, 0, 0));
    EXPECT_EQ(summed_influence({}, 200), Vec3(0, 0, 0));
}

TEST(MotionIndicator, RefusesAStrokeWithoutEnds)
{
    EXPECT_EQ(motion_indicator({}).error().message,
              "the motion indicator has no points: draw it again");
    double const infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(motion_indicator(stroke_of({ { 0, 0, 0 }, { infinite, 0, 0 } })).error().fault,
              Fault::User);
}

} // namespace
} // namespace tractus::variation
