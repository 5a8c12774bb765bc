#include "app/methods/leaves/plant_leaves.h"

#include "app/methods/leaves/leaf_library.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>

namespace tractus::leaf {
namespace {

double area_of(CutLeaf const& leaf, std::array<std::uint32_t, 3> const& triangle)
{
    Vec2 const to_b = leaf.corners[triangle[1]] - leaf.corners[triangle[0]];
    Vec2 const to_c = leaf.corners[triangle[2]] - leaf.corners[triangle[0]];
    return (to_b.x() * to_c.y() - to_b.y() * to_c.x()) / 2;
}

class PlantLeaves : public testing::TestWithParam<std::string> { };

TEST_P(PlantLeaves, AreFewTrianglesThatBendAlongTheMidrib)
{
    auto const grammar = load_own_leaf_grammar(GetParam()).value();
    for (double const age : { 0.5, 0.9 }) {
        auto const sheet = grow_leaf_sheet(grammar, { .variants = 5, .age = age }).value();
        ASSERT_EQ(sheet.leaves.size(), 5u);
        for (auto const& leaf : sheet.leaves) {
            EXPECT_LE(leaf->triangles.size(), kMaxLeafTriangles);
            EXPECT_GE(std::ranges::count_if(leaf->corners, [](auto& at) { return at.x() == 0; }),
                      3);
            for (auto const& triangle : leaf->triangles) {
                EXPECT_GT(area_of(*leaf, triangle), -1e-9);
                // A triangle must not extend from one half of the leaf into the other.
                double low = 0;
                double high = 0;
                for (auto const corner : triangle) {
                    low = std::min(low, leaf->corners[corner].x());
                    high = std::max(high, leaf->corners[corner].x());
                }
                EXPECT_TRUE(low == 0 || high == 0);
            }
        }
    }
}

// On the atlas page, five leaves occupy the first five of sixteen cells.
TEST_P(PlantLeaves, LieInTheirCellsOfThePage)
{
    auto const grammar = load_own_leaf_grammar(GetParam()).value();
    auto const sheet = grow_leaf_sheet(grammar, { .variants = 5 }).value();
    for (std::size_t i = 0; i < sheet.leaves.size(); ++i)
        for (auto const& corner : sheet.leaves[i]->corners) {
            Vec2 const at = 4 * sheet.leaves[i]->in_picture(corner);
            EXPECT_GE(at.x(), double(i % 4) - 1e-9);
            EXPECT_LE(at.x(), double(i % 4 + 1) + 1e-9);
            EXPECT_GE(at.y(), double(i / 4) - 1e-9);
            EXPECT_LE(at.y(), double(i / 4 + 1) + 1e-9);
        }
}

INSTANTIATE_TEST_SUITE_P(Ours, PlantLeaves, testing::ValuesIn(leaf_names()), [](auto const& leaf) {
    auto name = leaf.param;
    std::erase(name, '-');
    return name;
});

TEST(PlantLeaf, IsTheSameEachTime)
{
    auto const grammar = load_own_leaf_grammar("lime").value();
    auto const text
        = lsystem::print_leaf_sheet(grow_leaf_sheet(grammar, { .variants = 2 }).value());
    EXPECT_EQ(lsystem::print_leaf_sheet(grow_leaf_sheet(grammar, { .variants = 2 }).value()), text);
}

} // namespace
} // namespace tractus::leaf
