// Tests of laws of growth that hold for any parameters and any markers.

#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/grow.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/light.h"
#include "engine/methods/self_organising/markers.h"
#include "engine/methods/self_organising/prune.h"
#include "engine/methods/self_organising/vigour.h"
#include "engine/methods/self_organising/wood.h"
#include "tests/engine/methods/self_organising/random_case.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numeric>
#include <utility>

namespace tractus::self_organising {
namespace {

constexpr std::uint64_t kCases = 12;
constexpr int kSteps = 7;
constexpr auto kSpace = Laws::Environment::Space;
constexpr auto kLight = Laws::Environment::Light;

GrowingTree grown(RandomCase const& random, int steps, Vec3 const& base = Vec3::Zero())
{
    auto tree = plant_seed(base);
    Surroundings surroundings { .markers = random.markers };
    for (int i = 0; i < steps; ++i)
        EXPECT_TRUE(grow_step(tree, surroundings, random.laws));
    return tree;
}

void expect_sound(GrowingTree const& tree)
{
    ASSERT_EQ(tree.places.size(), tree.size());
    ASSERT_EQ(tree.dead_wood.size(), tree.size());
    std::vector<int> borne(tree.size());
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        ASSERT_LE(node.first_lateral + node.lateral_count, tree.laterals.size());
        ASSERT_TRUE(i == 0 ? node.parent == kNone : node.parent < i);
        EXPECT_NEAR(tree.places[i].direction.norm(), 1, 1e-9);
        EXPECT_NEAR(tree.places[i].direction.dot(tree.places[i].normal), 0, 1e-9);
        for_each_child(tree, i, [&](std::uint32_t child) {
            ASSERT_LT(child, tree.size());
            EXPECT_EQ(tree.links[child].parent, i);
            ++borne[child];
        });
    }
    for (std::uint32_t i = 1; i < tree.size(); ++i)
        EXPECT_EQ(borne[i], 1) << "node " << i << " hangs on one node";
}

TEST(GrowthLaws, TreesAreSoundAfterEachStep)
{
    for (auto const environment : { kSpace, kLight })
        for (std::uint64_t seed = 0; seed < kCases; ++seed) {
            auto const random = random_case(seed, environment);
            auto tree = plant_seed(Vec3::Zero());
            Surroundings surroundings { .markers = random.markers };
            for (int i = 0; i < kSteps; ++i) {
                auto const before = tree.size();
                auto const count = grow_step(tree, surroundings, random.laws);
                ASSERT_TRUE(count) << count.error().message;
                EXPECT_EQ(count->nodes, tree.size());
                EXPECT_LE(tree.size(), before + count->grown);
                expect_sound(tree);
            }
            EXPECT_GT(tree.size(), 10U) << seed;
        }
}

TEST(GrowthLaws, NoMarkerNearABudSurvives)
{
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        auto random = random_case(seed, kSpace);
        auto const tree = grown(random, 4);
        auto const buds = living_buds(tree);
        auto markers = random.markers;
        compete_for_space(markers, tree, buds, random.laws);
        EXPECT_LT(markers.size(), random.markers.size());
        for (auto const& marker : markers)
            for (auto const& bud : buds)
                EXPECT_GE((marker - tree.places[bud.node].position).norm(),
                          random.laws.occupancy_radius);
        // All other markers must stay, in their order.
        auto at = random.markers.begin();
        for (auto const& marker : markers) {
            at = std::find(at, random.markers.end(), marker);
            ASSERT_NE(at, random.markers.end());
        }
    }
}

// Compares the result with the law applied directly: each marker is compared with all buds.
TEST(GrowthLaws, MarkersGoToTheNearestBudThatPerceivesThem)
{
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        auto random = random_case(seed, kSpace);
        random.markers.resize(200);
        auto const tree = grown(random, 4);
        auto const buds = living_buds(tree);
        auto markers = random.markers;
        auto const perceived = compete_for_space(markers, tree, buds, random.laws);
        std::vector<double> quality(buds.size());
        std::vector<Vec3> pull(buds.size(), Vec3::Zero());
        for (auto const& marker : markers) {
            std::size_t best = buds.size();
            double least = random.laws.perception_radius;
            for (std::size_t k = 0; k < buds.size(); ++k) {
                Vec3 const way = marker - tree.places[buds[k].node].position;
                double const angle = std::acos(way.normalized().dot(direction_of(tree, buds[k])));
                if (way.norm() < least && angle <= radians(random.laws.perception_angle_deg) / 2) {
                    best = k;
                    least = way.norm();
                }
            }
            if (best == buds.size())
                continue;
            quality[best] = 1;
            pull[best] += (marker - tree.places[buds[best].node].position).normalized();
        }
        EXPECT_EQ(perceived.quality, quality);
        for (std::size_t k = 0; k < buds.size(); ++k)
            EXPECT_LT((perceived.direction[k] - unit_or_zero(pull[k])).norm(), 1e-9);
    }
}

TEST(GrowthLaws, VigourIsNeitherMadeNorLostAtNodes)
{
    for (auto const environment : { kSpace, kLight })
        for (std::uint64_t seed = 0; seed < kCases; ++seed) {
            auto random = random_case(seed, environment);
            auto const tree = grown(random, kSteps);
            auto const buds = living_buds(tree);
            Random chance({ .seed = seed });
            std::vector<double> quality;
            for (std::size_t i = 0; i < buds.size(); ++i)
                quality.push_back(std::max(chance.uniform(-0.5, 1), 0.0));
            auto const shares = share_vigour(tree, buds, quality, random.laws);
            double const received = std::accumulate(quality.begin(), quality.end(), 0.0);
            double const vigour = std::accumulate(shares.vigour.begin(), shares.vigour.end(), 0.0);
            EXPECT_NEAR(shares.received[0], received, 1e-9 * received);
            EXPECT_NEAR(vigour, random.laws.vigour * received, 1e-9 * received);
            for (std::size_t i = 0; i < buds.size(); ++i)
                EXPECT_EQ(shares.vigour[i] > 0, quality[i] > 0);
        }
}

TEST(GrowthLaws, APullToTheLeaderMakesItLonger)
{
    auto random = random_case(3, kLight);
    random.laws.shed_below = 0;
    auto const leader = [&](double control) {
        random.laws.apical_control = control;
        auto const tree = grown(random, 8);
        double length = 0;
        for (auto i = tree.links[0].main; i != kNone; i = tree.links[i].main)
            length += (tree.places[i].position - tree.places[tree.links[i].parent].position).norm();
        return length;
    };
    EXPECT_GT(leader(0.58), 1.2 * leader(0.42));
}

TEST(GrowthLaws, TurningEverythingTurnsTheTree)
{
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        auto random = random_case(seed, kSpace);
        random.laws.tropism_direction = Vec3(0.3, -0.2, 1);
        auto const rotation = Eigen::AngleAxisd(0.4 + double(seed), Vec3::UnitZ());
        auto turned_case = random;
        for (auto& marker : turned_case.markers)
            marker = rotation * marker;
        turned_case.laws.tropism_direction = rotation * random.laws.tropism_direction;
        // The trunk must not be vertical, because the reference normal of a vertical trunk is
        // always x.
        auto const grow = [](RandomCase const& of, Vec3 const& base, Vec3 const& direction) {
            auto tree = plant_seed(base, direction);
            Surroundings surroundings { .markers = of.markers };
            for (int i = 0; i < 5; ++i)
                EXPECT_TRUE(grow_step(tree, surroundings, of.laws));
            return tree;
        };
        Vec3 const base(0.5, 0.25, 0);
        Vec3 const direction(0.2, 0.1, 1);
        auto const tree = grow(random, base, direction);
        auto const turned_tree = grow(turned_case, rotation * base, rotation * direction);
        ASSERT_EQ(tree.size(), turned_tree.size()) << seed;
        for (std::size_t i = 0; i < tree.size(); ++i)
            EXPECT_LT((rotation * tree.places[i].position - turned_tree.places[i].position).norm(),
                      1e-6);
    }
}

TEST(GrowthLaws, TheOrderOfMarkersDoesNotMatter)
{
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        auto random = random_case(seed, kSpace);
        auto const tree = grown(random, kSteps);
        std::reverse(random.markers.begin(), random.markers.end());
        std::rotate(random.markers.begin(), random.markers.begin() + 137, random.markers.end());
        auto const other = grown(random, kSteps);
        ASSERT_EQ(tree.size(), other.size()) << seed;
        for (std::size_t i = 0; i < tree.size(); ++i)
            EXPECT_LT((tree.places[i].position - other.places[i].position).norm(), 1e-9);
    }
}

TEST(GrowthLaws, WoodIsConservedAtEachNode)
{
    for (std::uint64_t seed = 0; seed < kCases; ++seed) {
        auto random = random_case(seed, kLight);
        random.laws.keeps_dead_wood = seed % 2 == 0;
        auto const tree = grown(random, kSteps + 1);
        auto const widths = diameters(tree, random.laws);
        double const e = random.laws.pipe_exponent;
        for (std::size_t i = 0; i < tree.size(); ++i) {
            double sum = tree.dead_wood[i];
            for_each_child(tree, i,
                           [&](std::uint32_t child) { sum += std::pow(widths[child], e); });
            double const expected = sum > 0 ? std::pow(sum, 1 / e) : random.laws.twig_diameter;
            EXPECT_NEAR(widths[i], expected, 1e-12 * expected);
        }
    }
}

TEST(GrowthLaws, DeadWoodKeepsTheTrunkFromShrinking)
{
    auto random = random_case(5, kLight);
    random.laws.keeps_dead_wood = true;
    random.laws.shed_below = 0.4;
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings;
    std::map<std::pair<std::uint64_t, std::uint32_t>, double> before;
    std::size_t shed = 0;
    for (int i = 0; i < 12; ++i) {
        auto const size = tree.size();
        auto const count = grow_step(tree, surroundings, random.laws).value();
        shed += size + count.grown - count.nodes;
        auto const widths = diameters(tree, random.laws);
        for (std::size_t n = 0; n < tree.size(); ++n) {
            auto& width = before[{ tree.links[n].axis, tree.links[n].rank }];
            EXPECT_GE(widths[n], width * (1 - 1e-12));
            width = widths[n];
        }
    }
    EXPECT_GT(shed, 20U) << "some branches died";
}

// A tree of 18 years whose habit has rings of the given width on the trunk.
GrowingTree tree_with_rings(double ring_mm, Habit& habit)
{
    habit = { .terminal_loss = 0.1, .weight = 0.2, .ring_mm = ring_mm };
    return grow_without_brush(habit, 18, 3).value();
}

TEST(GrowthLaws, WithoutRingsThePipeModelIsShown)
{
    Habit habit;
    auto const tree = tree_with_rings(0, habit);
    EXPECT_EQ(shown_diameters(tree, habit), diameters(tree, growth_laws_in_year(habit, tree.step)));
}

TEST(GrowthLaws, RingsWidenTheTrunkAndItsBranchesOnly)
{
    Habit habit;
    auto const without = tree_with_rings(0, habit);
    auto const tree = tree_with_rings(5, habit);
    ASSERT_EQ(tree.size(), without.size());
    auto const pipes = diameters(tree, growth_laws_in_year(habit, tree.step));
    auto const shown = shown_diameters(tree, habit);
    std::size_t widened = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        EXPECT_EQ(tree.places[i].position, without.places[i].position) << "rings add no weight";
        EXPECT_GE(shown[i], pipes[i]);
        widened += shown[i] > pipes[i] ? 1U : 0U;
        if (node.order > 1 || node.step == tree.step) {
            EXPECT_EQ(shown[i], pipes[i]);
        }
        if (node.order == 0) {
            EXPECT_GE(shown[i], habit.twig_mm + 2 * habit.ring_mm * (tree.step - node.step));
        }
        if (node.parent != kNone) {
            EXPECT_LE(shown[i], shown[node.parent]) << "wood narrows from the base to the tips";
        }
    }
    EXPECT_GT(widened, 20U);
}

TEST(GrowthLaws, RingsAreNarrowerWhereInternodesAreShort)
{
    Habit habit;
    auto tree = tree_with_rings(5, habit);
    auto const full = shown_diameters(tree, habit);
    for (auto& place : tree.places)
        place.position *= 0.1;
    auto const pipes = diameters(tree, growth_laws_in_year(habit, tree.step));
    auto const small = shown_diameters(tree, habit);
    EXPECT_LT(small[0] - habit.twig_mm, 0.5 * (full[0] - habit.twig_mm));
    for (std::size_t i = 0; i < tree.size(); ++i)
        EXPECT_GE(small[i], pipes[i]);
}

TEST(GrowthLaws, RingsNeverShrinkNotEvenWhereTheTrunkIsCut)
{
    Habit habit;
    auto tree = tree_with_rings(5, habit);
    auto const before = shown_diameters(tree, habit);
    std::map<std::pair<std::uint64_t, std::uint32_t>, double> known;
    double height_mm = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        known[{ tree.links[i].axis, tree.links[i].rank }] = before[i];
        height_mm = std::max(height_mm, tree.places[i].position.z());
    }
    std::vector<BrushBall> const balls { { .centre = Vec3(0, 0, 0.6 * height_mm),
                                           .radius = 0.1 * height_mm } };
    ASSERT_GT(prune(tree, balls, habit, 1).value(), 0U);
    auto const after = shown_diameters(tree, habit);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        auto const was = known.find({ tree.links[i].axis, tree.links[i].rank });
        ASSERT_NE(was, known.end());
        EXPECT_GE(after[i], was->second * (1 - 1e-12));
    }
}

TEST(GrowthLaws, AxesKeepTheirNamesAsTheTreeGrows)
{
    auto random = random_case(2, kLight);
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings;
    std::map<std::pair<std::uint64_t, std::uint32_t>, Vec3> places;
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(grow_step(tree, surroundings, random.laws));
        std::size_t known = 0;
        std::map<std::pair<std::uint64_t, std::uint32_t>, Vec3> now;
        for (std::size_t n = 0; n < tree.size(); ++n) {
            auto const& node = tree.links[n];
            auto const [entry, is_new]
                = now.try_emplace({ node.axis, node.rank }, tree.places[n].position);
            EXPECT_TRUE(is_new) << "two nodes of one name";
            auto const old = places.find({ node.axis, node.rank });
            known += old != places.end();
            if (old != places.end()) {
                EXPECT_EQ(old->second, entry->second);
            }
        }
        EXPECT_TRUE(i == 0 || known > 0);
        places = std::move(now);
    }
}

TEST(GrowthLaws, LateralsOfAWhorlStandEvenlyAround)
{
    auto random = random_case(4, kLight);
    random.laws.laterals_at_node = 1;
    random.laws.whorl = 5;
    random.laws.shade = 0.03;
    auto const tree = grown(random, 5);
    int whorls = 0;
    for (std::size_t i = 1; i < tree.size(); ++i) {
        auto const& node = tree.links[i];
        if (node.lateral_count != 5)
            continue;
        ++whorls;
        EXPECT_EQ(node.order, 0);
        Vec3 sum = Vec3::Zero();
        for (auto const& lateral : tree.laterals_of(i)) {
            sum += lateral.direction;
            EXPECT_NEAR(lateral.direction.dot(tree.places[i].direction),
                        std::cos(radians(random.laws.branching_angle_deg.at(0))), 1e-9);
        }
        Vec3 const across = sum - tree.places[i].direction * sum.dot(tree.places[i].direction);
        EXPECT_LT(across.norm(), 1e-9);
    }
    EXPECT_GE(whorls, 4);
}

TEST(GrowthLaws, TooManyInternodesAreRefusedAndTheTreeStays)
{
    auto random = random_case(1, kLight);
    random.laws.most_nodes = 60;
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings;
    Result<StepCount> count;
    std::size_t before = 0;
    for (int i = 0; i < 50 && count; ++i) {
        before = tree.size();
        count = grow_step(tree, surroundings, random.laws);
    }
    ASSERT_FALSE(count);
    EXPECT_EQ(count.error().message,
              "the tree would have more than 60 internodes: grow it for fewer years, or with less "
              "vigour");
    EXPECT_EQ(tree.size(), before);
}

TEST(GrowthLaws, LawsOutOfRangeAreNamed)
{
    EXPECT_TRUE(check_laws({}));
    Laws laws;
    laws.apical_control = 1.5;
    EXPECT_EQ(check_laws(laws).error().message, "apical_control is 1.5: give a number from 0 to 1");
    laws = {};
    laws.internode = std::nan("");
    EXPECT_FALSE(check_laws(laws));
    laws = {};
    laws.environment = kLight;
    laws.cell = 1e-3;
    EXPECT_FALSE(check_laws(laws)) << "a bud would look at a million million cells";
}

TEST(LightGrid, ShadesAPyramidBelowEachPoint)
{
    Laws laws;
    laws.cell = 0.5;
    laws.shade_depth = 2;
    std::vector<Vec3> const points { { 0.1, 0.1, 2.1 }, { 0.6, 0.1, 2.1 } };
    auto const grid = LightGrid::make(points, laws).value();
    EXPECT_EQ(grid.shade_at({ 0, 0, 4 }), 0.2);
    EXPECT_EQ(grid.shade_at({ 0, 0, 3 }), 0.1 + 0.1);
    EXPECT_EQ(grid.shade_at({ -1, 0, 3 }), 0.1) << "under the first point alone";
    EXPECT_EQ(grid.shade_at({ -2, 2, 2 }), 0.05);
    EXPECT_EQ(grid.shade_at({ 0, 0, 1 }), 0);
    EXPECT_EQ(grid.shade_at({ 0, 0, 5 }), 0);
    EXPECT_EQ(grid.shade_at({ 900, 0, 4 }), 0);
}

TEST(LightGrid, RefusesPointsTooFarApart)
{
    Laws laws;
    std::vector<Vec3> const points { Vec3::Zero(), Vec3::Constant(1e12) };
    auto const grid = LightGrid::make(points, laws);
    ASSERT_FALSE(grid);
    EXPECT_NE(grid.error().message.find("give a larger cell"), std::string::npos);
}

} // namespace
} // namespace tractus::self_organising
