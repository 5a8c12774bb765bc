#include "engine/methods/self_organising/grown_tree.h"

#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/tree_plant.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <tbb/global_control.h>
#include <vector>

namespace tractus::self_organising {
namespace {

constexpr int kYears = 18;

Habit small_habit()
{
    return { .name = "small",
             .internode_mm = 120,
             .vigour = 3,
             .vigour_old = 3,
             .apical_control = 0.56,
             .apical_control_old = 0.5,
             .terminal_loss = 0.1,
             .cell_mm = 300,
             .shed_below = 0.1,
             .shed_below_old = 0.1,
             .weight = 0.2 };
}

// Returns a stroke that begins on the desk and leads upwards and to the side. It is drawn in 2 s.
Stroke drawn_stroke(double aside_mm = 60)
{
    std::vector<TipSample> tips;
    for (int i = 0; i <= 80; ++i) {
        double const share = i / 80.0;
        tips.push_back({ .time = timestamp_ns(25'000'000LL * i),
                         .position_mm = Vec3(20 + aside_mm * share * share, 5, 10 + 160 * share),
                         .pressure = 0.8,
                         .touching = true });
    }
    return { std::move(tips) };
}

PlantTree by_itself(int years = kYears)
{
    return { .habit = small_habit(), .seed = 5, .first = { .years = years } };
}

PlantTree along_stroke()
{
    return { .habit = small_habit(),
             .seed = 5,
             .first = { .years = 12, .stroke = drawn_stroke() } };
}

scene::Scene after(std::vector<scene::Edit> const& edits)
{
    auto scene = scene::fold(edits);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().message);
    return scene ? *std::move(scene) : scene::Scene {};
}

std::string refusal(std::vector<scene::Edit> const& edits)
{
    auto const scene = scene::fold(edits);
    return scene ? std::string() : scene.error().message;
}

bool same_bytes(Plant const& one, Plant const& other)
{
    auto const same_organ = [](Organ const& a, Organ const& b) {
        return a.segment == b.segment && a.position_mm == b.position_mm
            && a.orientation.coeffs() == b.orientation.coeffs() && a.scale == b.scale;
    };
    return one.node_position_mm == other.node_position_mm
        && one.node_radius_mm == other.node_radius_mm
        && std::equal(one.organs.begin(), one.organs.end(), other.organs.begin(),
                      other.organs.end(), same_organ);
}

TEST(GrownTree, IsAPlantWithWoodAndLeaves)
{
    auto const scene = after({ by_itself() });
    check_plant(*scene.base);
    EXPECT_EQ(scene.model_name, "small");
    EXPECT_GT(scene.base->segment_count(), 500U);
    EXPECT_GT(scene.base->organs.size(), 100U);
    auto const box = bounds(*scene.base);
    EXPECT_GT(box.max_mm.z(), 3000);
    for (auto const& organ : scene.base->organs)
        ASSERT_NE(organ.segment, kNone);
}

TEST(GrownTree, StandsWhereTheBrushCameDown)
{
    auto const scene = after({ along_stroke() });
    check_plant(*scene.base);
    EXPECT_EQ(scene.drawn->stands_at_mm, Vec3(20, 5, 10));
    EXPECT_EQ(scene.state.scale, 0.1);
    auto const box = bounds(*scene.base);
    EXPECT_GT(box.max_mm.z(), 1000) << "160 mm on the desk are 1.6 m";
    EXPECT_LT(box.max_mm.z(), 2500);
}

TEST(GrownTree, BearsLeavesOnAllItsTwigsUnderTheBrush)
{
    auto const scene = after({ along_stroke() });
    std::set<SegmentId> leafy;
    for (auto const& organ : scene.base->organs)
        leafy.insert(organ.segment);
    for (auto const& axis : scene.base->axes)
        EXPECT_TRUE(leafy.contains(axis.first_segment + axis.segment_count - 1)
                    || std::any_of(scene.base->axes.begin(), scene.base->axes.end(),
                                   [&](Axis const& other) {
                                       return other.parent_segment
                                           == axis.first_segment + axis.segment_count - 1;
                                   }));
}

TEST(GrownTree, BearsTheNeedlesOfAnInternodeAsOneOrgan)
{
    auto habit = small_habit();
    habit.leaf_years = 3;
    habit.leaf_is_needle = 1;
    habit.leaf_mm = 24;
    habit.leaf_width_mm = 2;
    habit.shoot_needles = 40;
    auto const plant = plant_of(grow_without_brush(habit, 8, 5).value(), habit, 5).plant;
    check_plant(plant);
    ASSERT_FALSE(plant.organs.empty());
    for (auto const& shape : plant.organ_shapes)
        EXPECT_EQ(shape.spray.size(), 40u);
    std::set<SegmentId> segments;
    for (auto const& organ : plant.organs) {
        EXPECT_TRUE(segments.insert(organ.segment).second);
        auto const& axis = *std::ranges::find_if(plant.axes, [&](Axis const& one) {
            return organ.segment >= one.first_segment
                && organ.segment < one.first_segment + one.segment_count;
        });
        auto const below = axis.first_node + organ.segment - axis.first_segment;
        auto const& from_mm = plant.node_position_mm[below];
        Vec3 const internode_mm = plant.node_position_mm[below + 1] - from_mm;
        EXPECT_LT((organ.position_mm - from_mm).norm(), 1e-6);
        EXPECT_GT((organ.orientation * Vec3::UnitY()).dot(internode_mm.normalized()), 1 - 1e-9);
        // Needles stand along the whole internode, and are as long on a short one.
        EXPECT_NEAR(100 * double(organ.scale.y()), internode_mm.norm(), 1e-3);
        EXPECT_NEAR(double(organ.scale.x()), 1.2, 1e-6);
    }
}

TEST(GrownTree, IsTheSameOnOneThread)
{
    for (auto const& edit : { by_itself(), along_stroke() }) {
        auto const many = after({ edit });
        tbb::global_control const limit(tbb::global_control::max_allowed_parallelism, 1);
        auto const one = after({ edit });
        EXPECT_TRUE(same_bytes(*many.base, *one.base));
    }
}

TEST(GrownTree, AnotherSeedIsAnotherTree)
{
    auto other = by_itself();
    other.seed = 6;
    EXPECT_FALSE(same_bytes(*after({ by_itself() }).base, *after({ other }).base));
}

TEST(GrownTree, GrowsOnAsIfItHadNeverStopped)
{
    auto const plant = after({ by_itself(8) }).state.active;
    auto const whole = after({ by_itself(kYears) });
    auto const parts = after({ by_itself(8), GrowOn { plant, { .years = kYears - 8 } } });
    EXPECT_TRUE(same_bytes(*whole.base, *parts.base));
}

TEST(GrownTree, AxesKeepTheirKeys)
{
    auto habit = small_habit();
    habit.shed_below = habit.shed_below_old = 0;
    auto const young = plant_of(grow_without_brush(habit, 12, 5).value(), habit, 5);
    auto const old = plant_of(grow_without_brush(habit, kYears, 5).value(), habit, 5);
    std::set<std::uint32_t> const young_keys(young.keys.begin(), young.keys.end());
    std::map<std::uint32_t, AxisId> old_axes;
    for (AxisId i = 0; i < old.keys.size(); ++i)
        EXPECT_TRUE(old_axes.try_emplace(old.keys[i], i).second) << "keys are unique";
    ASSERT_EQ(young_keys.size(), young.plant.axes.size());
    EXPECT_FALSE(young_keys.contains(0));
    for (AxisId i = 0; i < young.keys.size(); ++i) {
        auto const found = old_axes.find(young.keys[i]);
        ASSERT_NE(found, old_axes.end()) << "none was shed";
        auto const& axis = old.plant.axes[found->second];
        EXPECT_GE(axis.segment_count, young.plant.axes[i].segment_count);
        EXPECT_EQ(axis.order, young.plant.axes[i].order);
    }
}

TEST(GrownTree, NoBranchShrinksInWidthAsItGrowsOn)
{
    auto const habit = small_habit();
    auto tree = plant_seed(Vec3::Zero());
    Surroundings surroundings { .seed = 5 };
    std::map<std::uint32_t, float> widths; // Width at the base of each axis.
    for (int year = 0; year < kYears; ++year) {
        ASSERT_TRUE(grow_year(tree, surroundings, habit));
        auto const made = plant_of(tree, habit, 5);
        for (AxisId i = 1; i < made.keys.size(); ++i) {
            auto const width = made.plant.node_radius_mm[made.plant.axes[i].first_node];
            auto& before = widths[made.keys[i]];
            EXPECT_GE(width, before * 0.999999F);
            before = width;
        }
    }
    EXPECT_GT(widths.size(), 300U);
}

TEST(GrownTree, AnotherHabitLivesTheSameLife)
{
    auto slender = small_habit();
    slender.name = "slender";
    slender.angle_deg = slender.lateral_angle_deg = 15;
    auto const plant = after({ along_stroke() }).state.active;
    auto const scene = after(
        { along_stroke(), GrowOn { plant, { .years = 3 } }, ChangeHabit { plant, slender, 5 } });
    auto direct = along_stroke();
    direct.habit = slender;
    EXPECT_TRUE(same_bytes(*scene.base, *after({ direct, GrowOn { plant, { .years = 3 } } }).base));
    EXPECT_TRUE(same_bytes(*after({ along_stroke() }).base,
                           *after({ along_stroke(), ChangeHabit { plant, slender, 9 },
                                    ChangeHabit { plant, small_habit(), 5 } })
                                .base))
        << "and back";
}

TEST(GrownTree, ABrushLeadsATreeOnWhereItStandsNow)
{
    auto const plant = after({ by_itself(6) }).state.active;
    std::vector<scene::Edit> const edits { along_stroke(),
                                           GrowOn { after({ along_stroke() }).state.active,
                                                    { .years = 8, .stroke = drawn_stroke(-90) } } };
    auto const before = after({ along_stroke() });
    auto const scene = after(edits);
    check_plant(*scene.base);
    EXPECT_GT(scene.base->segment_count(), before.base->segment_count());
    EXPECT_LT(bounds(*scene.base).min_mm.x(), bounds(*before.base).min_mm.x() - 200);
    EXPECT_EQ(plant, before.state.active);
}

TEST(GrownTree, SaysWhatItRefuses)
{
    auto edit = by_itself(0);
    EXPECT_EQ(refusal({ edit }), "a tree grows for 1 to 200 years, and 0 are asked for");
    edit = by_itself();
    edit.habit.vigour = -1;
    EXPECT_EQ(refusal({ edit }), "vigour is -1: give a number from 0 to 20");
    edit = by_itself();
    edit.habit.whorl = 2.5;
    EXPECT_EQ(refusal({ edit }), "whorl is 2.5: give a whole number from 0 to 8");
    edit = along_stroke();
    edit.first.min_radius_mm = edit.first.most_radius_mm = 0;
    EXPECT_EQ(refusal({ edit }), "the brush has no radius: give one above 0 mm");
    auto const plant = after({ by_itself(5) }).state.active;
    EXPECT_EQ(refusal({ by_itself(150), GrowOn { plant, { .years = 60 } } }),
              "the tree would be older than 200 years");
    EXPECT_NE(refusal({ by_itself(5), GrowOn { plant + 77, { .years = 1 } } }), "");
}

} // namespace
} // namespace tractus::self_organising
