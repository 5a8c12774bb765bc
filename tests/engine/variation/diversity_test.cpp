#include "engine/variation/diversity.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

// Returns a plant of nodes in a row, all of which are displaced by `offset`.
Plant row(std::size_t nodes, Vec3 const& offset)
{
    Plant plant;
    for (std::size_t i = 0; i < nodes; ++i)
        plant.node_position_mm.push_back(Vec3(0, 0, static_cast<double>(i)) + offset);
    return plant;
}

TEST(Diversity, IsTheRootMeanSquareOfTheNodesDistances)
{
    std::vector<Vec3> const one { { 0, 0, 0 }, { 0, 0, 10 } };
    std::vector<Vec3> const other { { 3, 4, 0 }, { 0, 0, 10 } };
    EXPECT_DOUBLE_EQ(distance_mm(one, other), std::sqrt(12.5));
    EXPECT_EQ(distance_mm(one, one), 0);
    EXPECT_EQ(distance_mm(std::vector<Vec3> {}, {}), 0);
}

TEST(Diversity, ComparesEveryPlantWithEveryOtherAndWithTheDrawnOne)
{
    // The distance is computed over all nodes of a small plant, and over a sample of the nodes of a
    // large one.
    for (std::size_t const nodes : { 3u, 10'000u }) {
        Diversity diversity(row(nodes, Vec3::Zero()));
        diversity.add(row(nodes, { 1, 0, 0 }));
        diversity.add(row(nodes, { -1, 0, 0 }));
        diversity.add(row(nodes, { 0, 0, 4 }));
        auto const drawn = diversity.from_drawn();
        EXPECT_EQ(drawn.count, 3u);
        EXPECT_NEAR(drawn.mean_mm, 2, 1e-12);
        EXPECT_NEAR(drawn.deviation_mm, std::sqrt(3), 1e-12);
        auto const pairs = diversity.between_plants();
        EXPECT_EQ(pairs.count, 3u);
        EXPECT_NEAR(pairs.mean_mm, (2 + 2 * std::sqrt(17)) / 3, 1e-12);
    }
}

TEST(Diversity, OfNoneOrOneHasNoSpread)
{
    Diversity diversity(row(5, Vec3::Zero()));
    EXPECT_EQ(diversity.from_drawn().count, 0u);
    diversity.add(row(5, { 0, 2, 0 }));
    EXPECT_EQ(diversity.between_plants().count, 0u);
    EXPECT_DOUBLE_EQ(diversity.from_drawn().mean_mm, 2);
    EXPECT_EQ(diversity.from_drawn().deviation_mm, 0);
}

} // namespace
} // namespace tractus::variation
