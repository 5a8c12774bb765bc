#include "engine/methods/silhouettes/trunk_reach.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <algorithm>

namespace tractus::silhouette {
namespace {

constexpr double kCrownRadius = 30;

// Returns the outline of a round crown whose lowest point is the origin.
std::vector<Vec2> round_crown()
{
    auto outline = ellipse(kCrownRadius, kCrownRadius).outline[0];
    for (auto& point : outline)
        point.y() += kCrownRadius;
    return outline;
}

std::vector<Vec2> trunk_below(double top, double length = 60)
{
    return { { 0, top - length }, { 0, top - length / 2 }, { 0, top } };
}

// A trunk below the crown must be extended through the gap and through 85 % of the crown's height.
TEST(TrunkReach, GoesThroughTheCrown)
{
    for (double const gap : { 0.5, 2.0, 5.0, 5.9 }) {
        auto const reach = extension_into_crown(trunk_below(-gap), round_crown());
        ASSERT_TRUE(reach) << gap;
        EXPECT_NEAR(*reach, gap + 0.85 * 2 * kCrownRadius, 0.2) << gap;
        auto trunk = trunk_below(-gap);
        go_on(trunk, *reach);
        EXPECT_NEAR((trunk.back() - Vec2(0, 0.85 * 2 * kCrownRadius)).norm(), 0, 0.2);
    }
}

TEST(TrunkReach, IsOfNearTrunksAlone)
{
    EXPECT_FALSE(extension_into_crown(trunk_below(-6.5), round_crown()))
        << "farther than a hand misses by";
    EXPECT_TRUE(extension_into_crown(trunk_below(-2, 20), round_crown()));
    EXPECT_FALSE(extension_into_crown(trunk_below(-4, 20), round_crown()))
        << "far for so short a trunk";
    EXPECT_FALSE(extension_into_crown(trunk_below(3), round_crown())) << "it is inside";
    EXPECT_FALSE(extension_into_crown(std::vector { Vec2(0, -3) }, round_crown()));
}

TEST(TrunkReach, IsOfTrunksThatPointIntoTheCrown)
{
    // These trunks must not be extended: one is beside the crown and parallel to it, one points
    // away from it, and one would only cut off a corner.
    Vec2 const side(kCrownRadius + 2, kCrownRadius);
    EXPECT_FALSE(
        extension_into_crown(std::vector { Vec2(side - Vec2(0, 60)), side }, round_crown()));
    EXPECT_FALSE(extension_into_crown(std::vector { Vec2(0, -2), Vec2(0, -60) }, round_crown()));
    EXPECT_FALSE(extension_into_crown(std::vector { Vec2(28, -50), Vec2(28, 18) }, round_crown()));
    // A leaning trunk, which reaches the crown from below at an angle.
    EXPECT_TRUE(extension_into_crown(std::vector { Vec2(-25, -50), Vec2(-1, -2) }, round_crown()));
}

// Most outlines begin and end above the end of the trunk. They need not be quite closed there.
TEST(TrunkReach, LooksAtTheOutlineAsItIsRead)
{
    auto open = round_crown();
    // Makes the outline begin at its lowest point.
    std::rotate(open.begin(), open.begin() + 150, open.end());
    ASSERT_LT(open.front().y(), 0.1);
    open.resize(open.size() - 6); // The outline ends 5 mm before its beginning.
    EXPECT_TRUE(extension_into_crown(trunk_below(-3), open));
}

} // namespace
} // namespace tractus::silhouette
