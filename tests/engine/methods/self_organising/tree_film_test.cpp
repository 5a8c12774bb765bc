#include "engine/methods/self_organising/tree_film.h"

#include "engine/variation/growth.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::self_organising {
namespace {

GrownTree tree_of(int years)
{
    return { .habit = { .name = "small",
                        .internode_mm = 120,
                        .vigour = 3,
                        .vigour_old = 3,
                        .cell_mm = 300,
                        .shed_below = 0.15,
                        .shed_below_old = 0.15,
                        .weight = 0.3 },
             .seed = 5,
             .life = { { .years = years } } };
}

TEST(TreeFilm, IsTheTreeOfEachYear)
{
    auto const film = TreeFilm::make(tree_of(9)).value();
    ASSERT_EQ(film.years(), 9);
    for (int year = 1; year <= 9; ++year) {
        auto const shown = film.plant_at(year);
        auto const grown = build_tree(tree_of(year), {}).value().plant;
        EXPECT_EQ(shown.node_position_mm, grown.node_position_mm);
        EXPECT_EQ(shown.node_radius_mm, grown.node_radius_mm);
        EXPECT_EQ(shown.organs.size(), grown.organs.size());
    }
    EXPECT_EQ(film.plant_at(-5).segment_count(), film.plant_at(0).segment_count());
    EXPECT_EQ(film.plant_at(99).segment_count(), film.plant_at(9).segment_count());
}

TEST(TreeFilm, EndsAsTheGrownTree)
{
    auto const film = TreeFilm::make(tree_of(9)).value();
    auto plant = film.whole();
    film.shape_at(9, plant);
    auto const grown = build_tree(tree_of(9), {}).value().plant;
    ASSERT_EQ(plant.node_position_mm.size(), grown.node_position_mm.size());
    for (std::size_t i = 0; i < plant.node_position_mm.size(); ++i) {
        EXPECT_LT((plant.node_position_mm[i] - grown.node_position_mm[i]).norm(), 1e-6);
        EXPECT_NEAR(plant.node_radius_mm[i], grown.node_radius_mm[i],
                    1e-4F * grown.node_radius_mm[i]);
    }
    auto const leaves = std::count_if(plant.organs.begin(), plant.organs.end(),
                                      [](Organ const& organ) { return organ.scale.x() > 0.5F; });
    EXPECT_EQ(static_cast<std::size_t>(leaves), grown.organs.size());
    check_plant(plant);
}

TEST(TreeFilm, NeverLetsABranchShrink)
{
    auto const film = TreeFilm::make(tree_of(10)).value();
    auto plant = film.whole();
    std::vector<double> lengths(plant.segment_count());
    std::vector<float> radii(plant.node_radius_mm.size());
    for (int frame = 0; frame <= 73; ++frame) {
        film.shape_at(10.0 * frame / 73, plant);
        for (auto const& axis : plant.axes) {
            auto const nodes = plant.positions(axis);
            for (std::uint32_t k = 0; k < axis.segment_count; ++k) {
                double const length = (nodes[k + 1] - nodes[k]).norm();
                auto& before = lengths[axis.first_segment + k];
                EXPECT_GE(length, before - 1e-9) << "frame " << frame;
                before = length;
            }
        }
        for (std::size_t i = 0; i < radii.size(); ++i) {
            EXPECT_GE(plant.node_radius_mm[i], radii[i] * 0.99999F) << "frame " << frame;
            radii[i] = plant.node_radius_mm[i];
        }
    }
    EXPECT_GT(*std::min_element(lengths.begin(), lengths.end()), 1) << "all have grown";
}

TEST(TreeFilm, BeginsWithNothing)
{
    auto const film = TreeFilm::make(tree_of(6)).value();
    auto plant = film.whole();
    film.shape_at(0, plant);
    check_plant(plant);
    EXPECT_EQ(bounds(plant).max_mm, bounds(plant).min_mm);
    for (auto const radius : plant.node_radius_mm)
        EXPECT_EQ(radius, 0);
    EXPECT_EQ(variation::without_unborn(plant).organs.size(), 0U);
    EXPECT_FALSE(TreeFilm::make({ .habit = tree_of(1).habit }));
}

TEST(TreeFilm, KeepsLeavesOnTheShootsOfTheirYear)
{
    auto const film = TreeFilm::make(tree_of(8)).value();
    for (int year = 1; year <= 8; ++year) {
        auto plant = film.whole();
        film.shape_at(year, plant);
        auto const shown = film.plant_at(year);
        auto const leaves
            = std::count_if(plant.organs.begin(), plant.organs.end(),
                            [](Organ const& organ) { return organ.scale.x() > 0.5F; });
        // The film leaves out leaves on branches that die later.
        EXPECT_LE(static_cast<std::size_t>(leaves), shown.organs.size());
        EXPECT_GT(leaves, 0);
    }
}

} // namespace
} // namespace tractus::self_organising
