#include "engine/methods/self_organising/stand.h"

#include "engine/plant/tree_measures.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::self_organising {
namespace {

Habit sapling()
{
    return { .name = "sapling",
             .internode_mm = 120,
             .vigour = 3,
             .vigour_old = 3,
             .apical_control = 0.52,
             .apical_control_old = 0.5,
             .divergence_spread_deg = 0,
             .angle_spread_deg = 0,
             .cell_mm = 300,
             .shade = 0.05,
             .shade_depth = 5,
             .shed_below = 0.1,
             .shed_below_old = 0.1,
             .weight = 0 };
}

constexpr double kScale = 0.1;

// Returns edits that plant trees at the given positions, in metres at natural size.
std::vector<scene::Edit> planted(std::vector<Vec2> const& places_m, Habit const& habit = sapling())
{
    std::vector<scene::Edit> edits;
    scene::ItemId id = 0;
    for (auto const& place : places_m) {
        edits.emplace_back(PlantTree {
            .habit = habit, .seed = 4, .scale = kScale, .first = { .years = 1 }, .id = ++id });
        edits.emplace_back(scene::MovePlant { id, 1000 * kScale * Vec3(place.x(), place.y(), 0) });
    }
    return edits;
}

scene::Scene scene_of(std::vector<scene::Edit> const& edits)
{
    auto scene = scene::fold(edits);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? *std::move(scene) : scene::Scene {};
}

scene::Scene grown(std::vector<Vec2> const& places_m, int years)
{
    auto edits = planted(places_m);
    edits.emplace_back(GrowStand { years });
    return scene_of(edits);
}

TEST(Stand, OfOneTreeGrowsAsTheTreeAlone)
{
    auto edits = planted({ { 0, 0 } });
    edits.emplace_back(GrowOn { 1, { .years = 14 } });
    auto const alone = scene_of(edits);
    auto const stand = grown({ { 0, 0 } }, 14);
    EXPECT_EQ(stand.base->node_position_mm, alone.base->node_position_mm);
}

TEST(Stand, OfTreesFarApartGrowsAsEachAlone)
{
    auto const alone = grown({ { 0, 0 } }, 12);
    auto const apart = grown({ { 0, 0 }, { 500, 0 }, { 0, -900 } }, 12);
    for (auto const& plant : apart.plants)
        EXPECT_EQ(plant->base->node_position_mm, alone.base->node_position_mm);
}

TEST(Stand, DoesNotDependOnTheOrderOfTrees)
{
    std::vector<Vec2> const places { { 0, 0 }, { 1.2, 0.3 }, { -0.7, 1.4 } };
    auto const forth = grown(places, 12);
    auto const back = grown({ places.rbegin(), places.rend() }, 12);
    for (std::size_t i = 0; i < places.size(); ++i) {
        auto const& one = forth.plants[i]->base->node_position_mm;
        auto const& other = back.plants[places.size() - 1 - i]->base->node_position_mm;
        // The sum of the shades in a cell is formed in another order, so positions are equal only
        // nearly.
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t k = 0; k < one.size(); ++k)
            EXPECT_LT((one[k] - other[k]).norm(), 1e-6);
    }
}

TEST(Stand, DrawsTreesUpAndClearsTheirTrunks)
{
    std::vector<Vec2> rows;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            rows.emplace_back(0.8 * x, 0.8 * y);
    // The fifth tree is the one in the middle of the stand.
    auto const forest = measure_tree(*grown(rows, 16).plants[4]->base);
    auto const open = measure_tree(*grown({ { 0, 0 } }, 16).base);
    EXPECT_LT(forest.internodes, 0.9 * static_cast<double>(open.internodes));
    EXPECT_LT(forest.crown_width_mm, open.crown_width_mm);
    EXPECT_GT(forest.slenderness, open.slenderness);
    EXPECT_GT(forest.crown_base_mm / forest.height_mm, open.crown_base_mm / open.height_mm);
}

TEST(Stand, IsShadedByPlantsOfOtherMethods)
{
    // The tree grows under a roof of branches, 1.5 m above the ground. A cell of the roof takes all
    // light.
    auto dark = sapling();
    dark.shade = 1;
    std::string roof = "#define STEPS 1\nLsystem: 1\nderivation length: 1\nAxiom: !(20)F(1500)";
    for (int i = 0; i < 36; ++i)
        roof += "[/(" + std::to_string(10 * i) + ")+(90)F(1500)F(1000)]";
    roof += "\nendlsystem\n";
    auto const load = scene::LoadModel { .source = { .text = roof } };
    std::vector<scene::Edit> edits { load };
    for (auto const& edit : planted({ { 0.3, 0 } }, dark))
        edits.push_back(edit);
    auto const before = scene_of(edits);
    edits.emplace_back(GrowStand { 6 });
    auto const shaded = scene_of(edits);
    ASSERT_EQ(shaded.plants.size(), 2U);
    EXPECT_EQ(shaded.plants[1]->base->segment_count(), before.plants[1]->base->segment_count());
    edits.insert(edits.end() - 1, scene::HidePlant { before.plants[0]->drawn->id });
    EXPECT_GT(scene_of(edits).plants[1]->base->segment_count(),
              before.plants[1]->base->segment_count());
}

TEST(Stand, KeepsNeighboursWhenATreeIsAnother)
{
    std::vector<Vec2> const places { { 0, 0 }, { 1, 0 } };
    auto const before = grown(places, 10);
    auto edits = planted(places);
    edits.emplace_back(GrowStand { 10 });
    edits.emplace_back(ChangeHabit { 1, sapling(), 99 });
    auto const after = scene_of(edits);
    EXPECT_EQ(after.plants[1]->base->node_position_mm, before.plants[1]->base->node_position_mm);
    // This habit has no random variation, so another seed gives the same tree.
    EXPECT_EQ(after.plants[0]->base->node_position_mm, before.plants[0]->base->node_position_mm);
    auto other = sapling();
    other.apical_control = 0.6;
    edits.back() = ChangeHabit { 1, other, 4 };
    EXPECT_NE(scene_of(edits).plants[0]->base->node_position_mm,
              before.plants[0]->base->node_position_mm);
}

TEST(Stand, GrowsOnInAnyOrderWithOtherYears)
{
    auto edits = planted({ { 0, 0 }, { 1, 0 } });
    edits.emplace_back(GrowStand { 5 });
    edits.emplace_back(GrowOn { 2, { .years = 3 } });
    edits.emplace_back(GrowStand { 2 });
    edits.emplace_back(GrowStand { 1 });
    auto const scene = scene_of(edits);
    std::array<int, 2> years {};
    for (std::size_t i = 0; i < 2; ++i)
        for (auto const& part : grown_tree_of(scene.plants[i]->drawn->source)->life)
            years[i] += part.years;
    EXPECT_EQ(years[0], 9);
    EXPECT_EQ(years[1], 12);
    EXPECT_EQ(scene_of(edits).plants[1]->base->node_position_mm,
              scene.plants[1]->base->node_position_mm);
}

TEST(Stand, NeedsATree)
{
    auto const none = scene::fold(std::vector<scene::Edit> { GrowStand { 1 } });
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("plant a tree first"), std::string::npos);
    auto edits = planted({ { 0, 0 } });
    edits.emplace_back(GrowStand { 0 });
    EXPECT_FALSE(scene::fold(edits));
    edits.back() = GrowStand { 200 };
    EXPECT_FALSE(scene::fold(edits)) << "it would be 201 years old";
}

} // namespace
} // namespace tractus::self_organising
