#include "engine/methods/self_organising/prune.h"

#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/wood.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tractus::self_organising {
namespace {

Habit hedge()
{
    return { .name = "hedge",
             .internode_mm = 80,
             .vigour = 3,
             .vigour_old = 3,
             .bud_life = 2,
             .cell_mm = 200,
             .shed_below = 0.1,
             .shed_below_old = 0.1,
             .weight = 0 };
}

GrowingTree grown(int years)
{
    return grow_without_brush(hedge(), years, 3).value();
}

// Returns a horizontal path of the pruning brush through the whole crown.
std::vector<BrushBall> level_cut(double height_mm, double radius_mm = 60)
{
    std::vector<BrushBall> balls;
    for (int row = -60; row <= 60; ++row)
        for (int k = -1; k <= 1; k += 2)
            balls.push_back(
                { .centre = Vec3(row % 2 == 0 ? k * 6000 : -k * 6000, 100.0 * row, height_mm),
                  .radius = radius_mm });
    return balls;
}

double top_of(GrowingTree const& tree)
{
    double top = 0;
    for (auto const& place : tree.places)
        top = std::max(top, place.position.z());
    return top;
}

// Expects consistent links and laterals in the tree, and that all of its wood is connected.
void expect_sound_wood(GrowingTree const& tree)
{
    std::vector<int> times_borne(tree.size());
    std::size_t laterals = 0;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        EXPECT_EQ(node.first_lateral, laterals) << "laterals lie in the order of nodes";
        laterals += node.lateral_count;
        for_each_child(tree, i, [&](std::uint32_t child) {
            ASSERT_LT(child, tree.size());
            EXPECT_EQ(tree.links[child].parent, i);
            ++times_borne[child];
        });
        for (auto const& lateral : tree.laterals_of(i))
            EXPECT_FALSE(lateral.has_bud && lateral.node != kNone);
    }
    EXPECT_EQ(laterals, tree.laterals.size());
    for (std::size_t i = 1; i < tree.size(); ++i)
        EXPECT_EQ(times_borne[i], 1);
}

TEST(Prune, CutsAHedgeThatGrowsBack)
{
    auto tree = grown(12);
    double const before = top_of(tree);
    double const height = 0.5 * before;
    ASSERT_GT(before, 1500);
    auto const removed = prune(tree, level_cut(height), hedge(), 3);
    ASSERT_TRUE(removed) << removed.error().message;
    EXPECT_GT(*removed, 100U);
    expect_sound_wood(tree);
    EXPECT_LT(top_of(tree), height) << "nothing is left above the cut, nor in it";
    auto const stumps = living_buds(tree).size();
    Surroundings surroundings { .seed = 3 };
    for (int year = 0; year < 6; ++year)
        ASSERT_TRUE(grow_year(tree, surroundings, hedge()));
    expect_sound_wood(tree);
    EXPECT_GT(living_buds(tree).size(), stumps);
    EXPECT_GT(top_of(tree), height + 200);
}

TEST(Prune, WakesBudsBelowTheCut)
{
    // The pole has no buds except the one at its tip, like old wood.
    auto habit = hedge();
    habit.laterals_at_node = 0;
    auto tree = grow_without_brush(habit, 8, 1).value();
    ASSERT_GT(top_of(tree), 900);
    ASSERT_TRUE(tree.laterals.empty());
    habit.laterals_at_node = 1;
    // The nodes of the pole are in order, so this is the node in its middle.
    auto const middle = tree.size() / 2;
    std::vector<BrushBall> const ball { { .centre = tree.places[middle].position, .radius = 10 } };
    ASSERT_GT(prune(tree, ball, habit, 1).value(), 0U);
    expect_sound_wood(tree);
    EXPECT_EQ(tree.size(), middle);
    auto const buds = living_buds(tree);
    EXPECT_EQ(buds.size(), 4U);
    for (auto const& bud : buds) {
        EXPECT_NE(bud.lateral, kNone);
        EXPECT_GE(bud.node, middle - 4);
    }
}

TEST(Prune, LeavesTheWidthOfTheWoodBelow)
{
    auto tree = grown(10);
    auto const laws = growth_laws_in_year(hedge(), tree.step);
    std::map<std::pair<std::uint64_t, std::uint32_t>, double> before;
    auto const widths = diameters(tree, laws);
    for (std::size_t i = 0; i < tree.size(); ++i)
        before[{ tree.links[i].axis, tree.links[i].rank }] = widths[i];
    ASSERT_GT(prune(tree, level_cut(0.6 * top_of(tree)), hedge(), 3).value(), 0U);
    auto const after = diameters(tree, laws);
    for (std::size_t i = 1; i < tree.size(); ++i)
        EXPECT_NEAR(after[i], before.at({ tree.links[i].axis, tree.links[i].rank }),
                    1e-9 * after[i] + 1e-9);
}

TEST(Prune, LeavesAStumpOfWhatIsCutWhole)
{
    auto tree = grown(8);
    std::vector<BrushBall> const all { { .centre = Vec3(0, 0, 0), .radius = 1e5 } };
    ASSERT_TRUE(prune(tree, all, hedge(), 3));
    EXPECT_EQ(tree.size(), 2U);
    expect_sound_wood(tree);
    Surroundings surroundings { .seed = 3 };
    for (int year = 0; year < 3; ++year)
        ASSERT_TRUE(grow_year(tree, surroundings, hedge()));
    EXPECT_GT(tree.size(), 5U) << "it sprouts from the stump";
}

TEST(Prune, TouchesNothingBesideTheTree)
{
    auto tree = grown(8);
    auto const before = tree.size();
    std::vector<BrushBall> const beside { { .centre = Vec3(1e4, 0, 0), .radius = 500 } };
    EXPECT_EQ(prune(tree, beside, hedge(), 3).value(), 0U);
    EXPECT_EQ(prune(tree, {}, hedge(), 3).value(), 0U);
    EXPECT_EQ(tree.size(), before);
    double const nan = std::numeric_limits<double>::quiet_NaN();
    for (double const radius : { 0.0, -5.0, nan, std::numeric_limits<double>::infinity() }) {
        std::vector<BrushBall> const wrong { { .radius = radius } };
        EXPECT_FALSE(prune(tree, wrong, hedge(), 3)) << radius;
    }
}

TEST(Prune, TurnsWithTheTree)
{
    // A quarter turn about the vertical axis maps the light grid's cells onto each other.
    auto const turn_quarter = [](Vec3 const& v) { return Vec3(-v.y(), v.x(), v.z()); };
    auto tree = grown(9);
    auto turned_tree = tree;
    for (auto& place : turned_tree.places)
        place = { turn_quarter(place.position), turn_quarter(place.direction),
                  turn_quarter(place.normal) };
    auto balls = level_cut(0.5 * top_of(tree), 150);
    std::erase_if(balls, [](BrushBall const& ball) { return ball.centre.y() > 0; });
    auto turned_balls = balls;
    for (auto& ball : turned_balls)
        ball.centre = turn_quarter(ball.centre);
    EXPECT_EQ(prune(tree, balls, hedge(), 3).value(),
              prune(turned_tree, turned_balls, hedge(), 3).value());
    ASSERT_EQ(tree.size(), turned_tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i)
        EXPECT_LT((turn_quarter(tree.places[i].position) - turned_tree.places[i].position).norm(),
                  1e-9);
}

// The tests below prune the trees of a document, with strokes in millimetres of the world.

Stroke level_stroke(double height_mm, double reach_mm)
{
    std::vector<TipSample> tips;
    for (int i = 0; i <= 200; ++i)
        tips.push_back({ .time = timestamp_ns(10'000'000LL * i),
                         .position_mm = Vec3(-reach_mm + reach_mm * i / 100, 0, height_mm),
                         .pressure = 1,
                         .touching = true });
    return { std::move(tips) };
}

Stroke upright_stroke(double height_mm)
{
    std::vector<TipSample> tips;
    for (int i = 0; i <= 100; ++i)
        tips.push_back({ .time = timestamp_ns(20'000'000LL * i),
                         .position_mm = Vec3(0, 0, height_mm * i / 100),
                         .pressure = 1,
                         .touching = true });
    return { std::move(tips) };
}

scene::Scene pruned_in_steps(std::vector<scene::Edit> const& edits)
{
    auto scene = scene::fold(edits);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? *std::move(scene) : scene::Scene {};
}

TEST(PruneEdit, CutsWhatTheStrokeTouchesAndLetsItGrowBack)
{
    scene::Edit const planted
        = PlantTree { .habit = hedge(), .seed = 3, .scale = 0.1, .first = { .years = 12 } };
    auto const before = pruned_in_steps({ planted });
    double const height_mm = bounds(*before.base).max_mm.z();
    LifePeriod const cut { .kind = LifePeriod::Kind::Prune,
                           .stroke = level_stroke(0.05 * height_mm, 0.2 * height_mm),
                           .min_radius_mm = 0.1 * height_mm,
                           .most_radius_mm = 0.1 * height_mm };
    auto const after = pruned_in_steps({ planted, GrowOn { before.state.active, cut } });
    check_plant(*after.base);
    EXPECT_LT(after.base->segment_count(), before.base->segment_count());
    for (auto const& node : after.base->node_position_mm)
        EXPECT_FALSE(std::abs(node.y()) < 0.5 * height_mm
                     && std::hypot(node.y(), node.z() - 0.5 * height_mm) < 0.99 * height_mm
                     && std::abs(node.x()) < 2 * height_mm && node.z() > 200)
            << "a node is left in the brush";
    auto const later = pruned_in_steps({ planted, GrowOn { before.state.active, cut },
                                         GrowOn { before.state.active, { .years = 5 } } });
    EXPECT_GT(later.base->segment_count(), after.base->segment_count());
    auto const* const tree = grown_tree_of(later.drawn->source);
    int years = 0;
    for (auto const& part : tree->life)
        years += years_of(part);
    EXPECT_EQ(years, 17) << "a cut takes no time";
}

TEST(ClearEdit, IsAsIfTheBrushHadNotBeenThere)
{
    LifePeriod const brushed {
        .years = 20, .stroke = upright_stroke(200), .min_radius_mm = 40, .most_radius_mm = 40
    };
    scene::Edit const planted
        = PlantTree { .habit = hedge(), .seed = 3, .scale = 0.1, .first = brushed };
    auto const before = pruned_in_steps({ planted });
    double const top_mm = bounds(*before.base).max_mm.z();
    LifePeriod const cleared { .kind = LifePeriod::Kind::Clear,
                               .stroke = level_stroke(160, 60),
                               .min_radius_mm = 60,
                               .most_radius_mm = 60 };
    scene::Edit const clear = GrowOn { before.state.active, cleared };
    auto const after = pruned_in_steps({ planted, clear });
    EXPECT_LT(bounds(*after.base).max_mm.z(), 0.75 * top_mm);
    EXPECT_GT(after.base->segment_count(), 20U);
    // A later stroke of the brush sows markers there again.
    auto const again = pruned_in_steps({ planted, clear, GrowOn { before.state.active, brushed } });
    EXPECT_GT(bounds(*again.base).max_mm.z(), 0.9 * top_mm);
}

TEST(ClearEdit, HoldsForAnotherHabitInTheSameVolume)
{
    LifePeriod const brushed {
        .years = 20, .stroke = upright_stroke(200), .min_radius_mm = 40, .most_radius_mm = 40
    };
    scene::Edit const planted
        = PlantTree { .habit = hedge(), .seed = 3, .scale = 0.1, .first = brushed };
    auto const id = pruned_in_steps({ planted }).state.active;
    scene::Edit const clear = GrowOn { id,
                                       { .kind = LifePeriod::Kind::Clear,
                                         .stroke = level_stroke(160, 60),
                                         .min_radius_mm = 60,
                                         .most_radius_mm = 60 } };
    auto other = hedge();
    other.name = "other";
    other.apical_control = 0.7;
    auto const first = pruned_in_steps({ planted, clear });
    for (std::uint64_t seed = 3; seed < 6; ++seed) {
        scene::Edit const change = ChangeHabit { id, other, seed };
        auto const changed = pruned_in_steps({ planted, clear, change });
        EXPECT_LT(bounds(*changed.base).max_mm.z(),
                  0.75 * bounds(*pruned_in_steps({ planted, change }).base).max_mm.z());
        EXPECT_NE(changed.base->node_position_mm, first.base->node_position_mm);
        auto const back = pruned_in_steps(
            { planted, clear, ChangeHabit { id, other, seed }, ChangeHabit { id, hedge(), 3 } });
        EXPECT_EQ(back.base->node_position_mm, first.base->node_position_mm);
    }
}

TEST(PruneEdit, RefusesWhatMeansNothing)
{
    scene::Edit const planted = PlantTree { .habit = hedge(), .first = { .years = 4 } };
    auto const id = pruned_in_steps({ planted }).state.active;
    auto const refusal = [&](LifePeriod const& part) {
        auto const scene = scene::fold(std::vector<scene::Edit> { planted, GrowOn { id, part } });
        return scene ? std::string() : scene.error().message;
    };
    EXPECT_NE(refusal({ .kind = LifePeriod::Kind::Prune }).find("the stroke is empty"),
              std::string::npos);
    EXPECT_NE(refusal({ .kind = LifePeriod::Kind::Clear }).find("the stroke is empty"),
              std::string::npos);
    EXPECT_NE(
        refusal(
            { .kind = LifePeriod::Kind::Prune, .stroke = level_stroke(10, 10), .min_radius_mm = 0 })
            .find("no radius"),
        std::string::npos);
    auto const first = scene::fold(std::vector<scene::Edit> { PlantTree {
        .habit = hedge(),
        .first = { .kind = LifePeriod::Kind::Prune, .stroke = level_stroke(10, 10) } } });
    ASSERT_FALSE(first);
    EXPECT_NE(first.error().message.find("let it grow first"), std::string::npos);
}

} // namespace
} // namespace tractus::self_organising
