#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

namespace tractus::self_organising {
namespace {

Habit habit_of_test()
{
    return { .name = "small",
             .internode_mm = 120,
             .vigour = 3,
             .vigour_old = 3,
             .apical_control = 0.56,
             .apical_control_old = 0.5,
             .cell_mm = 300,
             .shed_below = 0,
             .shed_below_old = 0,
             .weight = 0 };
}

scene::Scene folded(std::vector<scene::Edit> const& edits)
{
    auto scene = scene::fold(edits);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? *std::move(scene) : scene::Scene {};
}

// Returns an edit that loads a plant with a trunk and two limbs.
scene::Edit measured_plant()
{
    return scene::LoadModel { .source = { .text = "#define STEPS 1\n"
                                                  "Lsystem: 1\nderivation length: 1\n"
                                                  "Axiom: !(60)F(700)[+(50)F(600)]F(700)"
                                                  "[-(50)F(500)]F(600)\n"
                                                  "endlsystem\n" } };
}

// Returns the distance of a point from the nearest node of a plant.
double distance_to(Plant const& plant, Vec3 const& point)
{
    double least = 1e300;
    for (auto const& node : plant.node_position_mm)
        least = std::min(least, (node - point).norm());
    return least;
}

TEST(GrowFrom, MakesWoodOfAPlantOfAnotherKind)
{
    auto const before = folded({ measured_plant() });
    ASSERT_GT(before.base->axes.size(), 2U);
    auto const after = folded(
        { measured_plant(), GrowFrom { before.state.active, habit_of_test(), 3, { .years = 3 } } });
    check_plant(*after.base);
    EXPECT_EQ(after.plants.size(), 1U);
    EXPECT_GT(after.base->segment_count(), before.base->segment_count() + 20);
    for (auto const& node : before.base->node_position_mm)
        EXPECT_LT(distance_to(*after.base, node), 1e-6) << "what stood there stays";
    EXPECT_GT(bounds(*after.base).max_mm.z(), bounds(*before.base).max_mm.z() + 100);
    EXPECT_FALSE(after.base->organs.empty());
}

TEST(GrowFrom, KeepsWhatStoodThereInItsOwnShade)
{
    auto habit = habit_of_test();
    habit.shed_below = 0.3;
    habit.shed_below_old = 0.3;
    habit.shade = 1;
    auto const before = folded({ measured_plant() });
    auto const after
        = folded({ measured_plant(), GrowFrom { before.state.active, habit, 3, { .years = 1 } } });
    for (auto const& node : before.base->node_position_mm)
        EXPECT_LT(distance_to(*after.base, node), 1e-6);
}

TEST(GrowFrom, KeepsAtLeastTheWidthOfTheWood)
{
    auto const before = folded({ measured_plant() });
    auto const after = folded(
        { measured_plant(), GrowFrom { before.state.active, habit_of_test(), 3, { .years = 1 } } });
    auto const& foot = after.base->axes[0].first_node;
    EXPECT_GE(after.base->node_radius_mm[foot],
              before.base->node_radius_mm[before.base->axes[0].first_node] * 0.999F);
}

// Returns a stroke for the trunk: half a circle to one side.
Stroke bow()
{
    std::vector<TipSample> tips;
    for (int i = 0; i <= 60; ++i) {
        double const angle = i / 60.0 * kPi / 2;
        tips.push_back({ .time = timestamp_ns(10'000'000LL * i),
                         .position_mm = Vec3(150 * (1 - std::cos(angle)), 0, 150 * std::sin(angle)),
                         .pressure = 0.8,
                         .touching = true });
    }
    return { std::move(tips) };
}

TEST(GrowFrom, GoesOnFromWhereAStrokeHasBentTheTree)
{
    scene::Edit const planted
        = PlantTree { .habit = habit_of_test(), .seed = 5, .scale = 0.1, .first = { .years = 8 } };
    auto const straight = folded({ planted });
    auto const& trunk = straight.base->axes[0];
    variation::Selection path(1);
    for (SegmentId i = 0; i < trunk.segment_count; ++i)
        path[0].push_back(trunk.first_segment + i);
    std::vector<scene::Edit> edits { planted, scene::select_paths(straight, path),
                                     scene::Associate { .stroke = bow() } };
    auto const bent = folded(edits);
    ASSERT_EQ(bent.associations.size(), 1U);
    edits.emplace_back(GrowFrom { straight.state.active, habit_of_test(), 5, { .years = 1 } });
    auto const grown = folded(edits);
    check_plant(*grown.base);
    EXPECT_TRUE(grown.associations.empty()) << "the bow is in the wood";
    auto const& plant = *grown.base;
    auto const nodes = plant.positions(plant.axes[0]);
    Vec3 const was = straight.base->positions(trunk).back();
    Vec3 const is = nodes[trunk.segment_count];
    EXPECT_GT(is.x(), was.x() + 300) << "the end of the old trunk lies to the side";
    EXPECT_GT(plant.axes[0].segment_count, trunk.segment_count) << "and goes on from there";
    double length_mm = 0;
    double straight_mm = 0;
    for (std::uint32_t i = 0; i < trunk.segment_count; ++i) {
        length_mm += (nodes[i + 1] - nodes[i]).norm();
        straight_mm
            += (straight.base->positions(trunk)[i + 1] - straight.base->positions(trunk)[i]).norm();
    }
    EXPECT_NEAR(length_mm, straight_mm, 0.05 * straight_mm);
    Vec3 const last = (nodes[trunk.segment_count + 1] - is).normalized();
    Vec3 const before = (is - nodes[trunk.segment_count - 1]).normalized();
    EXPECT_GT(last.dot(before), 0.7) << "in the direction that it has there";
}

TEST(GrowFrom, KeepsTheNamesOfAxes)
{
    scene::Edit const planted = PlantTree { .habit = habit_of_test(), .first = { .years = 6 } };
    auto const before = folded({ planted });
    auto const after
        = folded({ planted, GrowFrom { before.state.active, habit_of_test(), 1, { .years = 2 } } });
    auto const old_keys = before.drawn->source.build({})->axis_keys;
    auto const new_keys = after.drawn->source.build({})->axis_keys;
    std::set<std::uint32_t> const known(new_keys.begin(), new_keys.end());
    for (auto const key : old_keys)
        EXPECT_TRUE(known.contains(key));
    auto const direct = folded({ planted, GrowOn { before.state.active, { .years = 2 } } });
    EXPECT_EQ(after.base->node_position_mm, direct.base->node_position_mm)
        << "a tree that nothing has bent grows as it would have";
}

TEST(GrowFrom, SaysWhatCannotGrow)
{
    auto const before = folded({ measured_plant() });
    auto const refused = [&](GrowFrom const& edit) {
        std::vector<scene::Edit> const edits { measured_plant(), edit };
        auto const scene = scene::fold(edits);
        return scene ? std::string() : scene.error().message;
    };
    EXPECT_NE(refused({ before.state.active + 9, habit_of_test(), 1, {} }), "");
    EXPECT_NE(refused({ before.state.active, habit_of_test(), 1, { .years = 0 } }), "");
    auto wrong = habit_of_test();
    wrong.pipe_exponent = 9;
    EXPECT_NE(refused({ before.state.active, wrong, 1, {} }).find("pipe_exponent"),
              std::string::npos);
}

} // namespace
} // namespace tractus::self_organising
