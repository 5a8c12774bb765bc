#include "engine/variation/branch_tree.h"

#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

using Path = std::vector<SegmentId>;

Path children(BranchTree const& tree, SegmentId segment)
{
    auto const span = tree.children_of(segment);
    return { span.begin(), span.end() };
}

TEST(BranchTree, JoinsSegmentsAcrossAxes)
{
    auto const tree = build_branch_tree(hand_made_plant());
    EXPECT_EQ(tree.parent[0], kNone);
    EXPECT_EQ(children(tree, 0), (Path { 1 }));
    EXPECT_EQ(children(tree, 1), (Path { 2, 4 }));
    EXPECT_EQ(children(tree, 4), (Path { 5, 7 }));
    EXPECT_EQ(children(tree, 8), Path {});
}

TEST(BranchTree, CountsDepthFromTheGround)
{
    auto const tree = build_branch_tree(hand_made_plant());
    EXPECT_EQ(tree.depth[0], 0u);
    EXPECT_EQ(tree.depth[4], 2u);
    EXPECT_EQ(tree.depth[8], 4u);
    EXPECT_EQ(tree.axis[8], 2u);
}

TEST(BranchTree, KnowsDescendants)
{
    auto const tree = build_branch_tree(hand_made_plant());
    EXPECT_TRUE(tree.is_descendant(8, 4));
    EXPECT_TRUE(tree.is_descendant(8, 0));
    EXPECT_TRUE(tree.is_descendant(4, 4));
    EXPECT_FALSE(tree.is_descendant(4, 8));
    EXPECT_FALSE(tree.is_descendant(3, 4));
    EXPECT_FALSE(tree.is_descendant(9, 4));
}

TEST(BranchTree, PathsCrossFromAxisToAxis)
{
    auto const tree = build_branch_tree(hand_made_plant());
    EXPECT_EQ(path_between(tree, 0, 8), (Path { 0, 1, 4, 7, 8 }));
    EXPECT_EQ(path_between(tree, 5, 5), (Path { 5 }));
}

TEST(BranchTree, SeveralPlantsMayStandOnTheGround)
{
    auto plant = pole(3);
    add_axis(plant, straight({ 9, 0, 0 }, { 9, 0, 100 }, 2));
    auto const tree = build_branch_tree(plant);
    EXPECT_EQ(tree.parent[3], kNone);
    EXPECT_FALSE(tree.is_descendant(3, 0));
    EXPECT_TRUE(tree.is_descendant(4, 3));
}

TEST(BranchTree, HoldsAMillionSegments)
{
    auto const plant = forking_tree(17, 8);
    auto const tree = build_branch_tree(plant);
    ASSERT_EQ(tree.size(), 131'071u * 8);
    EXPECT_EQ(tree.rank_end[0], tree.size());
    EXPECT_EQ(tree.depth.back(), 17u * 8 - 1);
    EXPECT_EQ(path_between(tree, 0, static_cast<SegmentId>(tree.size() - 1)).size(), 17u * 8);
}

TEST(BranchTree, OfAnEmptyPlantIsEmpty)
{
    EXPECT_EQ(build_branch_tree({}).size(), 0u);
}

} // namespace
} // namespace tractus::variation
