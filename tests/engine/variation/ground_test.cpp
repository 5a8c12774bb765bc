#include "engine/variation/ground.h"

#include "engine/plant/join_axes.h"
#include "engine/variation/growth.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

// Returns a trunk with a root below it, and with a branch at its top that has a twig. Each of these
// four axes has a leaf.
Plant rooted_plant()
{
    Plant plant;
    plant.organ_shapes = { OrganShape {} };
    add_axis(plant, straight({ 0, 0, 0 }, { 0, 0, 100 }, 2));
    add_axis(plant, straight({ 0, 0, 50 }, { 150, 0, 50 }, 6), 0, 0);
    add_axis(plant, straight({ 150, 0, 50 }, { 150, 40, 50 }, 2), 1, 7);
    add_axis(plant, straight({ 0, 0, 0 }, { 60, 0, -80 }, 2)); // Adds the root.
    plant.organs = { Organ { .segment = 7, .position_mm = { 150, 0, 50 } },
                     Organ { .segment = 11, .position_mm = { 60, 0, -80 } } };
    return plant;
}

// Returns the plant after a stroke has bent its branch, which hangs straight down from its middle
// on.
Plant hanging(Plant const& base)
{
    return grow({ .plant = base,
                  .associations
                  = { { .path = segments_of(base.axes[1]),
                        .stroke = stroke_of({ { 0, 0, 0 }, { 75, 0, 0 }, { 75, 0, -75 } }),
                        .laying = StrokeLaying::HeadingAndPitch } },
                  .parameters = { .strength = 0 } })
        .value();
}

TEST(Ground, CountsWhatStrokesHaveBentBelowItAndNotRoots)
{
    auto const base = rooted_plant();
    EXPECT_TRUE(segments_underground(base, base).empty());
    auto const bent = hanging(base);
    // The branch begins at a height of 50 mm, and its segments are 25 mm long. So its last segment
    // and the twig are below the ground.
    EXPECT_EQ(segments_underground(bent, base), (std::vector<SegmentId> { 7, 8, 9 }));
    EXPECT_EQ(describe_underground(3, base), "3 of 12 segments are below the ground");
    EXPECT_EQ(describe_underground(1, base), "1 of 12 segments is below the ground");
    EXPECT_EQ(describe_underground(0, base), "");
}

TEST(Ground, BendsBranchesAlongItAndLeavesRoots)
{
    auto const base = rooted_plant();
    auto const before = hanging(base);
    auto bent = before;
    bend_along_ground(bent, base);
    check_plant(bent);
    EXPECT_TRUE(segments_underground(bent, base).empty());
    for (SegmentId segment = 0; segment < base.segment_count(); ++segment) {
        auto const nodes = nodes_of(base, segment);
        auto const length = [&](Plant const& plant) {
            return (plant.node_position_mm[nodes.tip] - plant.node_position_mm[nodes.base]).norm();
        };
        EXPECT_NEAR(length(bent), length(base), 1e-9) << segment;
    }
    // The root and all parts above the ground must stay, with their organs.
    for (NodeId const node : { 0u, 1u, 2u, 3u, 4u, 5u, 6u, 13u, 14u, 15u })
        EXPECT_EQ(bent.node_position_mm[node], before.node_position_mm[node]) << node;
    EXPECT_EQ(bent.organs[1].position_mm, before.organs[1].position_mm);
    // The underside of the branch's tip must lie on the ground, and its leaf must still be on the
    // tip.
    Vec3 const tip = bent.node_position_mm[9];
    EXPECT_NEAR(tip.z(), bent.node_radius_mm[9], 1e-9);
    EXPECT_LT((bent.organs[0].position_mm - tip).norm(), 1e-9);
    // If no part is below the ground, the plant must stay unchanged to the last bit.
    auto same = base;
    bend_along_ground(same, base);
    EXPECT_EQ(same.node_position_mm, base.node_position_mm);
}

} // namespace
} // namespace tractus::variation
