#include "engine/methods/sketch_lsystem/change_edits.h"

#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/scene.h"
#include "engine/scene/varied_scene.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"
#include "tests/engine/scene/edits.h"

#include <gtest/gtest.h>

namespace tractus::sketch {
namespace {

GrowAlongStroke drawn(Rule const& rule)
{
    GrowAlongStroke edit { .rule = rule, .leaves = Leaves::Bare };
    for (auto const& place_mm : bow())
        edit.stroke.tips.push_back({ .position_mm = place_mm, .touching = true });
    return edit;
}

Rule const kFirst { .angle_deg = 52, .shortest_mm = 4 };
Rule const kOther { .first_length_mm = 25, .laterals = 3, .angle_deg = 70, .shortest_mm = 4 };

// A plant whose rule is changed must be equal to a plant drawn with the new rule.
TEST(ChangeSketch, IsThePlantOfTheOtherRule)
{
    auto const scene = scene::after({ drawn(kFirst) });
    auto const changed
        = scene::after({ ChangeSketch { scene.state.active, 0, kOther, Leaves::Bare } }, scene);
    auto const again = scene::after({ drawn(kOther) });
    EXPECT_EQ(changed.base->node_position_mm, again.base->node_position_mm);
    EXPECT_EQ(changed.placement.origin_mm, again.placement.origin_mm);
}

TEST(ChangeSketch, KeepsWhatWasDrawnOnBranches)
{
    auto scene = scene::after({ drawn(kFirst) });
    auto const path = segments_of(scene.base->axes[1]);
    scene = scene::after({ scene::select_paths(scene, { path }),
                           scene::Associate { scene::stroke_towards({ 40, 0, 0 }) } },
                         scene);
    auto steeper = kFirst;
    steeper.angle_deg = 20;
    auto const changed
        = scene::after({ ChangeSketch { scene.state.active, 0, steeper, Leaves::Leafy } }, scene);
    ASSERT_EQ(changed.associations.size(), 1u);
    EXPECT_FALSE(changed.associations[0].what.is_orphaned);
    EXPECT_EQ(changed.associations[0].what.path.vector(), path);
    EXPECT_GT(changed.base->organs.size(), 0u);
}

TEST(ChangeSketch, RefusesRulesThatGrowNothing)
{
    auto const scene = scene::after({ drawn(kFirst) });
    auto rule = kFirst;
    rule.laterals = 99;
    EXPECT_FALSE(
        scene::apply_edit(scene, ChangeSketch { scene.state.active, 0, rule, Leaves::Bare }));
    EXPECT_FALSE(
        scene::apply_edit(scene, ChangeSketch { scene.state.active, 77, kOther, Leaves::Bare }));
    EXPECT_FALSE(scene::apply_edit(scene, ShortenSketch { scene.state.active, 0, 3 }))
        << "no internode";
}

// The prefix law: a shortened stroke must give the plant of a stroke that was drawn only up to
// there.
TEST(ShortenSketch, IsThePlantOfTheShorterStroke)
{
    auto const scene = scene::after({ drawn(kFirst) });
    auto const whole = newest_grown(*scene.drawn);
    ASSERT_TRUE(whole);
    auto const tips = count_tips(*whole->sketch, 3);
    ASSERT_TRUE(tips && *tips);
    auto const shortened = scene::after({ ShortenSketch { scene.state.active, 0, **tips } }, scene);
    EXPECT_EQ(shortened.base->axes[0].segment_count, 3u);
    auto begun = drawn(kFirst);
    begun.stroke.tips.own().resize(**tips);
    EXPECT_EQ(shortened.base->node_position_mm, scene::after({ begun }).base->node_position_mm);
    for (NodeId node = 0; node <= 3; ++node)
        EXPECT_EQ(shortened.base->node_position_mm[node], scene.base->node_position_mm[node]);
    EXPECT_EQ(count_tips(*whole->sketch, 1000).value(), std::nullopt);
}

// A plant whose stroke is redrawn must be equal to the plant that the new stroke alone makes.
TEST(RedrawSketch, IsThePlantOfTheOtherStroke)
{
    auto const scene = scene::after({ drawn(kFirst) });
    auto other = drawn(kFirst);
    for (auto& tip : other.stroke.tips.own())
        tip.position_mm += Vec3(30, 0.2 * tip.position_mm.z(), 0);
    auto const again = scene::after(
        { RedrawSketch { scene.state.active, 0, other.surface, other.stroke } }, scene);
    auto const alone = scene::after({ other });
    ASSERT_EQ(again.plants.size(), 1u);
    EXPECT_EQ(again.base->node_position_mm, alone.base->node_position_mm);
    EXPECT_NE(again.base->node_position_mm, scene.base->node_position_mm);
    EXPECT_EQ(again.placement.origin_mm, alone.placement.origin_mm);
    Stroke dot;
    dot.tips.own().resize(2);
    EXPECT_FALSE(scene::apply_edit(
        scene, RedrawSketch { scene.state.active, 0, StrokeSurface::Space, dot }));
}

TEST(ChangeSketch, ReachesWhatWasPutOnAnotherPlant)
{
    auto first = drawn(kFirst);
    auto scene = scene::after({ first, drawn(kFirst) });
    auto const host = scene.plants[0]->drawn->id;
    auto const guest = scene.plants[1]->drawn->id;
    auto const& parent = *scene.plants[0];
    auto const at = parent.rest->addresses.address_of(*parent.base, 4);
    scene = scene::after({ scene::GraftPlant { guest, host, at } }, scene);
    auto const grown = newest_grown(*scene.drawn);
    ASSERT_TRUE(grown);
    EXPECT_EQ(grown->part, guest);
    auto const axis_of_part = [&](scene::Scene const& wanted) {
        auto const stem = in_part(part_prefix(guest), { 0, 0 });
        auto const segment = wanted.rest->addresses.find_segment(*wanted.base, stem);
        return wanted.base->axes[axis_of(*wanted.base, segment.value())];
    };
    auto const changed
        = scene::after({ ChangeSketch { host, guest, kOther, Leaves::Bare } }, scene);
    EXPECT_NE(axis_of_part(changed).segment_count, axis_of_part(scene).segment_count);
    auto const tips = count_tips(*grown->sketch, 2).value().value();
    auto const shortened = scene::after({ ShortenSketch { host, guest, tips } }, scene);
    EXPECT_EQ(axis_of_part(shortened).segment_count, 2u);
    EXPECT_EQ(shortened.base->axes[0].segment_count, scene.base->axes[0].segment_count);
    auto longer = drawn(kFirst).stroke;
    for (auto& tip : longer.tips.own())
        tip.position_mm *= 1.5;
    auto const redrawn
        = scene::after({ RedrawSketch { host, guest, StrokeSurface::Space, longer } }, scene);
    EXPECT_GT(axis_of_part(redrawn).segment_count, axis_of_part(scene).segment_count);
    EXPECT_EQ(redrawn.plants[0]->placement.origin_mm, scene.plants[0]->placement.origin_mm);
}

// With another seed, the laterals must differ, the drawn axis must stay, and strokes must stay on
// their branches.
TEST(GrowAlongStroke, VariesItsLaterals)
{
    auto scene = scene::after({ drawn(kFirst) });
    auto const path = segments_of(scene.base->axes[1]);
    scene = scene::after({ scene::select_paths(scene, { path }),
                           scene::Associate { scene::stroke_towards({ 40, 0, 0 }) } },
                         scene);
    ASSERT_TRUE(scene::has_sources_that_vary(scene));
    auto const one = scene::varied(scene, { .seed = 7, .plant = 1 }).value();
    auto const again = scene::varied(scene, { .seed = 7, .plant = 1 }).value();
    auto const other = scene::varied(scene, { .seed = 7, .plant = 2 }).value();
    EXPECT_EQ(one.base->node_position_mm, again.base->node_position_mm);
    EXPECT_NE(one.base->node_position_mm, other.base->node_position_mm);
    auto const drawn_axis = [](scene::Scene const& grown) {
        auto const nodes = grown.base->positions(grown.base->axes[0]);
        return std::vector<Vec3>(nodes.begin(), nodes.end());
    };
    EXPECT_EQ(drawn_axis(one), drawn_axis(scene));
    EXPECT_EQ(drawn_axis(other), drawn_axis(scene));
    ASSERT_EQ(one.associations.size(), 1u);
    EXPECT_FALSE(one.associations[0].what.is_orphaned);
    auto const not_at_all = scene::varied(scene, { .seed = 7, .plant = 1, .spread = 0 }).value();
    EXPECT_EQ(not_at_all.base, scene.base);
}

} // namespace
} // namespace tractus::sketch
