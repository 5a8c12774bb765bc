#include "engine/stroke/foot_first.h"

#include "engine/base/random.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace tractus {
namespace {

using sketch::bow;
using sketch::half_circle;
using sketch::polyline;
using sketch::straight_stroke;

std::vector<Vec3> reversed(std::vector<Vec3> line)
{
    std::reverse(line.begin(), line.end());
    return line;
}

TEST(FootFirst, KnowsStrokesThatRunDown)
{
    EXPECT_FALSE(is_drawn_to_foot(straight_stroke(100), {}));
    EXPECT_TRUE(is_drawn_to_foot(reversed(straight_stroke(100)), {}));
    EXPECT_FALSE(is_drawn_to_foot(half_circle(50), {}));
    EXPECT_FALSE(is_drawn_to_foot(reversed(half_circle(50)), {}));
    EXPECT_TRUE(is_drawn_to_foot(reversed(bow()), {}));
    EXPECT_FALSE(is_drawn_to_foot(polyline({ { 0, 0, 10 }, { 80, 0, 0 } }), {})) << "flat";
    EXPECT_FALSE(is_drawn_to_foot(polyline({ { 0, 0, 90 }, { 0, 0, -30 }, { 10, 0, 0 } }), {}))
        << "comes up again";
    EXPECT_FALSE(is_drawn_to_foot({}, {}));
    EXPECT_FALSE(is_drawn_to_foot(std::vector { Vec3(1, 2, 3) }, {}));
}

TEST(FootFirst, LeavesWhatHangsAboveTheGround)
{
    auto const hanging = polyline({ { 0, 0, 300 }, { 5, 0, 200 } });
    EXPECT_FALSE(is_drawn_to_foot(hanging, 0));
    EXPECT_TRUE(is_drawn_to_foot(hanging, 190));
}

TEST(FootFirst, KnowsStrokesThatEndAtTheFootOfABranch)
{
    // A branch that rises to the right, from 300 mm above the ground.
    Vec3 const foot_mm(0, 0, 300);
    Vec3 const tip_mm(80, 0, 360);
    auto const along = polyline({ { 2, 3, 302 }, { 40, 0, 340 }, { 85, 0, 355 } });
    EXPECT_FALSE(is_drawn_to_foot_of(along, foot_mm, tip_mm));
    EXPECT_TRUE(is_drawn_to_foot_of(reversed(along), foot_mm, tip_mm));
    auto const elsewhere = polyline({ { 185, 0, 355 }, { 140, 0, 340 }, { 102, 3, 302 } });
    EXPECT_FALSE(is_drawn_to_foot_of(elsewhere, foot_mm, tip_mm)) << "ends beside the foot";
    auto const behind = polyline({ { -90, 0, 300 }, { 0, 0, 301 } });
    EXPECT_FALSE(is_drawn_to_foot_of(behind, foot_mm, tip_mm)) << "comes from the other side";
    EXPECT_FALSE(is_drawn_to_foot_of({}, foot_mm, tip_mm));
}

TEST(FootFirst, OfAStrokeAndItsReverseOneRunsToItsFootAtMost)
{
    Random random({ 1, 2, 3 });
    for (int n = 0; n < 300; ++n) {
        std::vector<Vec3> line { Vec3::Zero() };
        for (int i = 0; i < 12; ++i)
            line.push_back(line.back()
                           + Vec3(random.normal(), random.normal(), random.normal() - 0.7));
        EXPECT_FALSE(is_drawn_to_foot(line, {}) && is_drawn_to_foot(reversed(line), {}));
    }
}

TEST(FootFirst, TurnedTwiceAStrokeIsItself)
{
    Stroke stroke;
    for (int i = 0; i < 5; ++i)
        stroke.tips.push_back({ .time = timestamp_ns(7 * i * i),
                                .position_mm = { 1.0 * i, 0, 100.0 - i },
                                .pressure = 0.1 * i,
                                .touching = true });
    auto const turned = turned_round(stroke);
    auto const& tips = turned.tips.vector();
    ASSERT_EQ(tips.size(), 5U);
    EXPECT_EQ(tips.front().position_mm, Vec3(4, 0, 96));
    EXPECT_EQ(tips.front().pressure, 0.4);
    for (std::size_t i = 0; i < tips.size(); ++i)
        EXPECT_EQ(tips[i].time, stroke.tips.vector()[i].time);
    auto const twice = turned_round(turned);
    for (std::size_t i = 0; i < tips.size(); ++i)
        EXPECT_EQ(twice.tips.vector()[i].position_mm, stroke.tips.vector()[i].position_mm);
    EXPECT_TRUE(turned_round(Stroke {}).tips.empty());
}

} // namespace
} // namespace tractus
