#include "engine/methods/silhouettes/bump_leaf.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "tests/engine/methods/silhouettes/outlines.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace tractus::silhouette {
namespace {

// A leaf made where a branch ends must be that branch's part of the crown. If it is drawn as an
// outline, it must become the outline of this branch.
TEST(BumpLeaf, IsTheBranchsPartOfTheCrown)
{
    for (auto const& drawing : { lobed_crown(5), lobed_crown(7), star(8, 40, 80) }) {
        auto const skeleton = skeleton_of_lines(drawing);
        std::size_t found = 0;
        for (auto const& branch : skeleton.systems[0].branches) {
            if (branch.origin != Branch::Origin::Bump)
                continue;
            auto const leaf = leaf_on_bump(skeleton, branch.path.curve.end, Search::OnTrunk);
            ASSERT_TRUE(leaf) << name_of(branch);
            EXPECT_EQ(leaf->branch, name_of(branch));
            EXPECT_EQ(leaf->outline, branch.crown);
            EXPECT_EQ(branch_outlined_by(drawing, leaf->outline).value(), leaf->branch);
            ++found;
        }
        EXPECT_GE(found, 4u);
    }
}

TEST(BumpLeaf, IsNowhereElse)
{
    auto const drawing = lobed_crown(5);
    auto const skeleton = skeleton_of_lines(drawing);
    EXPECT_FALSE(leaf_on_bump(skeleton, { 0, 0 }, Search::AnyLevel)) << "the crown's middle";
    EXPECT_FALSE(leaf_on_bump(skeleton, { 200, 0 }, Search::AnyLevel)) << "beside it";
    for (auto const& bump : skeleton.systems[0].bumps)
        if (bump.role != Role::Lateral) {
            EXPECT_FALSE(leaf_on_bump(skeleton, bump.end, Search::AnyLevel)) << "the trunk's end";
        }
    // The outline of a leaf has two bumps, in which its midrib begins and ends.
    EXPECT_FALSE(leaf_on_bump(skeleton_of_lines(ellipse(20, 50)), { 3, 4 }, Search::AnyLevel));
}

TEST(BumpLeaf, IsOfTheSmallestOutlineAround)
{
    auto drawing = lobed_crown(5);
    ASSERT_TRUE(add_own_outline(drawing, limb()));
    auto const limb_of = drawing.own_outlines[0].branch;
    auto const skeleton = skeleton_of_lines(drawing);
    auto const at = skeleton.at(limb_of).value();
    auto const& system = skeleton.systems[skeleton.system_of[at.system][at.branch]];
    auto const bough = std::find_if(system.branches.begin(), system.branches.end(),
                                    [](auto& one) { return one.origin == Branch::Origin::Bump; });
    ASSERT_NE(bough, system.branches.end());
    Vec2 const place = bough->path.curve.end;
    EXPECT_EQ(leaf_on_bump(skeleton, place, Search::AnyLevel)->branch,
              limb_of + kPathSeparator + name_of(*bough));
    EXPECT_NE(leaf_on_bump(skeleton, place, Search::OnTrunk).value_or(BumpLeaf {}).branch,
              limb_of + kPathSeparator + name_of(*bough));
}

} // namespace
} // namespace tractus::silhouette
