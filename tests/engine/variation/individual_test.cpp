#include "engine/variation/individual.h"

#include "engine/plant/join_axes.h"
#include "tests/engine/variation/plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <utility>

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
    Vec3 const extent_mm = bounds(plant).max_mm - bounds(plant).min_mm;
    double const range
        // The range is larger for a narrow plant, such as this one.
        = 0.2 * (2 - extent_mm.head<2>().maxCoeff() / extent_mm.z());
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
    EXPECT_GT(range, 0.2);
    EXPECT_GT(smallest, 1 - range);
    EXPECT_LT(smallest, 1 - 0.75 * range);
    EXPECT_LT(largest, 1 + range);
    EXPECT_GT(largest, 1 + 0.75 * range);
    EXPECT_GT(farthest, 0.5) << "some face the other way";
}

TEST(Individual, OfANarrowPlantDiffersMoreInSize)
{
    // Returns the minimum and maximum size of many individuals of a tree whose ratio of width to
    // height is `wide`.
    auto const extremes = [](double wide) {
        auto plant = forking_tree(6, 4);
        plant.organs.clear();
        auto const box = bounds(plant);
        Vec3 const extent_mm = box.max_mm - box.min_mm;
        double const factor = wide * extent_mm.z() / extent_mm.head<2>().maxCoeff();
        for (auto& node_mm : plant.node_position_mm)
            node_mm.head<2>() *= factor;
        double least = 9;
        double most = 0;
        for (std::uint32_t index = 0; index < 400; ++index) {
            auto const other = individual(plant, { 3, index }, { .size = 0.4 }, none(plant));
            double const size
                = (bounds(other).max_mm.z() - bounds(other).min_mm.z()) / extent_mm.z();
            least = std::min(least, size);
            most = std::max(most, size);
        }
        return std::pair(least, most);
    };
    for (double const wide : { 1.0, 3.0 }) {
        auto const [least, most] = extremes(wide);
        EXPECT_NEAR(least, 0.6, 0.01);
        EXPECT_NEAR(most, 1.4, 0.01);
    }
    auto const [least, most] = extremes(0);
    EXPECT_NEAR(least, 1 - 0.4 * kNarrowSize, 0.03);
    EXPECT_NEAR(most, 1 + 0.4 * kNarrowSize, 0.03);
    auto const [less, more] = extremes(0.5);
    EXPECT_NEAR(less, 1 - 0.4 * (1 + kNarrowSize) / 2, 0.03);
    EXPECT_NEAR(more, 1 + 0.4 * (1 + kNarrowSize) / 2, 0.03);
}

TEST(Individual, IsComparedWithItsMissingBranchesWhereTheyWouldBegin)
{
    auto const plant = forking_tree(6, 4);
    Individuality const how { .branches = 0.2, .size = 0.3, .turn = 1 };
    std::size_t missing = 0;
    for (std::uint32_t index = 0; index < 20; ++index) {
        PlantKey const key { 3, index };
        auto const shown = individual(plant, key, how, none(plant));
        auto const compared = comparable_individual(plant, key, how, none(plant));
        ASSERT_EQ(compared.axes.size(), plant.axes.size());
        auto const is_shown = [&](Vec3 const& place) {
            return std::any_of(shown.node_position_mm.begin(), shown.node_position_mm.end(),
                               [&](Vec3 const& node) { return (node - place).norm() < 1e-6; });
        };
        for (auto const& axis : compared.axes) {
            auto const nodes = compared.positions(axis);
            bool const is_point = (nodes.back() - nodes.front()).norm() == 0;
            missing += is_point ? 1 : 0;
            EXPECT_TRUE(is_shown(nodes.back())) << "a missing branch is a place on its bearer";
        }
        EXPECT_EQ(comparable_individual(plant, key, { .turn = 1 }, none(plant)).node_position_mm,
                  individual(plant, key, { .turn = 1 }, none(plant)).node_position_mm);
    }
    EXPECT_GT(missing, 0u);
}

} // namespace
} // namespace tractus::variation
