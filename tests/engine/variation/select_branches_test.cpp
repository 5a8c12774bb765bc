#include "engine/variation/select_branches.h"

#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

using Path = std::vector<SegmentId>;

TEST(SelectBranches, ALongPathIsChosenByItsTwoEnds)
{
    auto const tree = build_branch_tree(hand_made_plant());
    EXPECT_EQ(path_by_ends(tree, 0, 8).value(), (Path { 0, 1, 4, 7, 8 }));
    EXPECT_EQ(path_by_ends(tree, 8, 1).value(), (Path { 1, 4, 7, 8 }));
    EXPECT_EQ(path_by_ends(tree, 5, 5).value(), Path { 5 });
    EXPECT_EQ(path_by_ends(tree, 8, 3).error().message,
              "no way from the root to a tip passes both ends: choose two ends of which one bears "
              "the other");
    EXPECT_FALSE(path_by_ends(build_branch_tree({}), 0, 0));
}

TEST(SelectBranches, AllOfOneOrder)
{
    auto const plant = hand_made_plant();
    EXPECT_EQ(axes_of_order(plant, 0), (Selection { { 0, 1, 2, 3 } }));
    EXPECT_EQ(axes_of_order(plant, 1), (Selection { { 4, 5, 6 }, { 9, 10 } }));
    EXPECT_EQ(axes_of_order(plant, 2), (Selection { { 7, 8 } }));
    EXPECT_TRUE(axes_of_order(plant, 3).empty());
    EXPECT_TRUE(axes_of_order({}, 0).empty());
}

TEST(SelectBranches, SiblingsAreAlikeByParentAndLength)
{
    auto plant = hand_made_plant();
    // The lengths of these siblings are 150 and 100 mm, so they are similar.
    EXPECT_EQ(similar_siblings(plant, 5), (Selection { { 4, 5, 6 }, { 9, 10 } }));
    EXPECT_EQ(similar_siblings(plant, 8), (Selection { { 7, 8 } }));
    add_axis(plant, straight({ 0, 0, 300 }, { 0, 30, 300 }, 2), 0, 2);
    // With a length of only 30 mm, the new sibling is not similar.
    EXPECT_EQ(similar_siblings(plant, 5).size(), 2u);
}

TEST(SelectBranches, InvertedTwiceIsTheSameSegments)
{
    auto const plant = hand_made_plant();
    Selection const selection { { 1, 4, 7 } };
    auto const others = inverted(plant, selection);
    EXPECT_EQ(others, (Selection { { 0 }, { 2, 3 }, { 5, 6 }, { 8 }, { 9, 10 } }));
    EXPECT_EQ(inverted(plant, others), (Selection { { 1 }, { 4 }, { 7 } }));
    EXPECT_EQ(inverted(plant, {}).size(), plant.axes.size());
    EXPECT_TRUE(inverted({}, {}).empty());
}

TEST(SelectBranches, AddToAndTakeFrom)
{
    Selection const trunk { { 0, 1, 2, 3 } };
    EXPECT_EQ(added(trunk, { { 9, 10 }, { 0, 1, 2, 3 } }),
              (Selection { { 0, 1, 2, 3 }, { 9, 10 } }));
    EXPECT_EQ(taken(trunk, { { 2 } }), (Selection { { 0, 1 }, { 3 } }));
    EXPECT_TRUE(taken(trunk, trunk).empty());
    EXPECT_EQ(taken(trunk, {}), trunk);
}

} // namespace
} // namespace tractus::variation
