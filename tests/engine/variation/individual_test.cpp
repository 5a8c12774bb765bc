#include "engine/variation/individual.h"

#include "engine/plant/join_axes.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace tractus::variation {
namespace {

std::vector<bool> none(Plant const& plant)
{
    return std::vector<bool>(plant.axes.size());
}

TEST(Individual, IsThePlantItselfWithoutIndividuality)
{
    auto const plant = hand_made_plant();
    auto const same = individual(plant, { 1, 2 }, {}, none(plant));
    EXPECT_EQ(same.node_position_mm, plant.node_position_mm);
    EXPECT_EQ(same.axes.size(), plant.axes.size());
}

TEST(Individual, LosesAndDoublesBranchesAndIsSound)
{
    auto const plant = forking_tree(8, 4); // A plant with 254 lateral axes.
    double lost = 0;
    double more = 0;
    std::set<std::size_t> counts;
    for (std::uint32_t index = 0; index < 40; ++index) {
        auto const other = individual(plant, { 7, index }, { .branches = 0.1 }, none(plant));
        check_plant(other);
        counts.insert(other.axes.size());
        auto const stays = individual(plant, { 7, index }, { .branches = 0.1 }, none(plant));
        EXPECT_EQ(other.node_position_mm, stays.node_position_mm) << "one key, one plant";
        lost += other.axes.size() < plant.axes.size() ? 1 : 0;
        more += other.axes.size() > plant.axes.size() ? 1 : 0;
    }
    EXPECT_GT(counts.size(), 20u);
    EXPECT_GT(lost, 5);
    EXPECT_GT(more, 5);
}

TEST(Individual, KeepsWhatWasDrawnAndWhatBearsIt)
{
    auto const plant = forking_tree(6, 4);
    AxisId const twig = static_cast<AxisId>(plant.axes.size() - 1);
    auto const kept = axes_below_paths(plant, { segments_of(plant.axes[twig]) });
    EXPECT_EQ(std::count(kept.begin(), kept.end(), true), 6) << "one axis of each order";
    Vec3 const tip = plant.positions(plant.axes[twig]).back();
    for (std::uint32_t index = 0; index < 50; ++index) {
        auto const other = individual(plant, { 3, index }, { .branches = 0.5 }, kept);
        EXPECT_TRUE(std::any_of(other.node_position_mm.begin(), other.node_position_mm.end(),
                                [&](Vec3 const& node) { return node == tip; }))
            << index;
    }
}

TEST(Individual, IsTurnedAndSizedAboutItsBase)
{
    auto const plant = hand_made_plant();
    double const height_mm = bounds(plant).max_mm.z();
    double smallest = 2;
    double largest = 0;
    double farthest = 0;
    for (std::uint32_t index = 0; index < 60; ++index) {
        Individuality const how { .size = 0.2, .turn = 1 };
        auto const other = individual(plant, { 5, index }, how, none(plant));
        check_plant(other);
        double const size = bounds(other).max_mm.z() / height_mm;
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
        EXPECT_NEAR(other.node_radius_mm[0], size * plant.node_radius_mm[0], 1e-5);
        EXPECT_NEAR(other.organs[0].scale.x(), size, 1e-5);
        Vec3 const right = other.positions(other.axes[1]).back();
        EXPECT_NEAR(right.head<2>().norm(), size * 150, 1e-6);
        farthest = std::max(farthest, -right.normalized().x());
    }
    EXPECT_GT(smallest, 0.8);
    EXPECT_LT(smallest, 0.85);
    EXPECT_LT(largest, 1.2);
    EXPECT_GT(largest, 1.15);
    EXPECT_GT(farthest, 0.5) << "some face the other way";
}

} // namespace
} // namespace tractus::variation
