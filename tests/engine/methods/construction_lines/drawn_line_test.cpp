#include "engine/methods/construction_lines/drawn_line.h"

#include "tests/engine/methods/construction_lines/sketches.h"

namespace tractus::lines {
namespace {

TEST(DrawnLine, HeadingsOfACircleTurnEvenly)
{
    std::vector<Vec2> points;
    for (auto const& point : arc(100, 90, 400))
        points.push_back(point.head<2>());
    DrawnLine const line(points);
    EXPECT_NEAR(line.length_mm(), 157.0795, 1e-4);
    for (int i = 0; i <= 8; ++i)
        EXPECT_NEAR(line.heading_deg(i / 8.0 * line.length_mm()), -90 * i / 8.0, 1e-6);
}

TEST(DrawnLine, HeadingsGoOnBeyondHalfATurn)
{
    DrawnLine const line({ Vec2(0, 0), Vec2(0, 10), Vec2(-10, 10), Vec2(-10, 0), Vec2(0, 0) });
    EXPECT_DOUBLE_EQ(line.heading_deg(10), 45);
    EXPECT_DOUBLE_EQ(line.heading_deg(30), 225);
}

TEST(DrawnLine, LinesThatMeetInAPointOfBothMeetOnce)
{
    DrawnLine const upright({ Vec2(0, 0), Vec2(0, 40), Vec2(0, 100) });
    DrawnLine const across({ Vec2(-60, 100), Vec2(0, 40), Vec2(40, 80) });
    auto const found = crossings(upright, across);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_DOUBLE_EQ(found[0].first_mm, 40);
    EXPECT_DOUBLE_EQ(found[0].second_mm, std::hypot(60, 60));
}

TEST(DrawnLine, ALinesLastPointBelongsToIt)
{
    DrawnLine const upright({ Vec2(0, 0), Vec2(0, 100) });
    EXPECT_EQ(crossings(upright, DrawnLine({ Vec2(-9, 100), Vec2(9, 100) })).size(), 1U);
    EXPECT_EQ(crossings(upright, DrawnLine({ Vec2(-9, 101), Vec2(9, 101) })).size(), 0U);
}

// Two scribbles that cross have millions of intersections, which must not fill the memory.
TEST(DrawnLine, ScribblesDoNotFillTheMemory)
{
    std::vector<Vec2> upright;
    std::vector<Vec2> level;
    for (int i = 0; i < 3'000; ++i) {
        upright.emplace_back(0.01 * i, i % 2 == 0 ? 0 : 100);
        level.emplace_back(i % 2 == 0 ? -10 : 110, 20 + 0.01 * i);
    }
    EXPECT_EQ(crossings(DrawnLine(upright), DrawnLine(level)).size(), kMaxCrossings);
}

TEST(DrawnLine, ARayMeetsTheNearestPiece)
{
    DrawnLine const line({ Vec2(-50, 0), Vec2(-50, 100), Vec2(-20, 100), Vec2(-20, 0) });
    EXPECT_DOUBLE_EQ(*line.nearest_hit_mm(Vec2(0, 50), direction(90)), 20);
    EXPECT_FALSE(line.nearest_hit_mm(Vec2(0, 50), direction(-90)));
}

} // namespace
} // namespace tractus::lines
