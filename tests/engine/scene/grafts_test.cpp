#include "engine/plant/join_axes.h"
#include "engine/plant/plant_addresses.h"
#include "engine/scene/scene_builder.h"
#include "engine/variation/growth.h"
#include "tests/engine/scene/edits.h"

#include <numeric>
#include <rapidcheck/gtest.h>

namespace tractus::scene {
namespace {

// Returns a trunk of four internodes. At the end of each of its first three internodes is a branch
// of two internodes.
LoadModel tree(Vec3 const& stands_at_mm = Vec3::Zero())
{
    return { .source = { .name = "tree.l",
                         .text = "Lsystem: 1\nderivation length: 0\n"
                                 "Axiom: F(10)[+(60)F(8)F(8)]F(10)[-(60)F(8)F(8)]"
                                 "F(10)[+(60)F(8)F(8)]F(10)\nA --> A\nendlsystem\n" },
             .drawn = Drawn::Beside,
             .stands_at_mm = stands_at_mm };
}

struct Two {
    Scene scene = after({ SetScale { 1 }, tree(), tree({ 100, 0, 0 }) });
    ItemId host = scene.plants[0]->drawn->id;
    ItemId guest = scene.plants[1]->drawn->id;

    // Returns an edit that grafts the second plant on the end of a segment of the first plant.
    GraftPlant on(SegmentId segment, Vec3 const& turn_rad = Vec3::Zero()) const
    {
        auto const& plant = *scene.plants[0];
        return { guest, host, plant.rest->addresses.address_of(*plant.base, segment), turn_rad };
    }
};

Vec3 tip_of(Plant const& plant, SegmentId segment)
{
    return plant.node_position_mm[nodes_of(plant, segment).tip];
}

Associate bend()
{
    return { .stroke = stroke_towards({ 40, 0, 0 }), .fit = variation::StrokeFit::World };
}

TEST(Grafts, APlantBecomesPartOfAnother)
{
    Two const two;
    auto const& branch = two.scene.plants[0]->base->axes[1];
    auto const on = branch.first_segment + 1;
    auto const scene = after({ two.on(on) }, two.scene);
    ASSERT_EQ(scene.plants.size(), 1u);
    EXPECT_EQ(scene.state.active, two.host);
    check_plant(*scene.base);
    EXPECT_EQ(scene.base->segment_count(), 20u);
    auto const& guest = scene.base->axes[4];
    EXPECT_EQ(guest.parent_segment, on);
    EXPECT_EQ(guest.order, 2u);
    EXPECT_EQ(scene.base->positions(guest)[0], tip_of(*scene.base, on));
    EXPECT_EQ(scene.placement.scale, 1);
}

TEST(Grafts, WhatWasDrawnOnBothStays)
{
    Two const two;
    auto scene = after({ select_paths(two.scene, { segments_of(two.scene.base->axes[2]) }), bend(),
                         ActivatePlant { two.host } },
                       two.scene);
    scene = after({ select_paths(scene, { segments_of(scene.base->axes[3]) }), bend() }, scene);
    auto const own_path = scene.associations[0].what.path.vector();
    auto const grafted = after({ two.on(3) }, scene);
    ASSERT_EQ(grafted.associations.size(), 2u);
    EXPECT_EQ(grafted.associations[0].what.path.vector(), own_path);
    EXPECT_EQ(grafted.associations[1].what.path.vector(), segments_of(grafted.base->axes[6]));
}

TEST(Grafts, FollowWhatBearsThem)
{
    Two const two;
    auto scene = after({ two.on(3) }, two.scene);
    auto const& trunk = scene.base->axes[0];
    scene = after({ select_paths(scene, { segments_of(trunk) }), bend() }, scene);
    auto const plan = plan_growth(scene);
    ASSERT_TRUE(plan);
    variation::Grower grower(*plan);
    auto const& grown = grower.grow({ 1, 0 }, 1);
    EXPECT_GT(tip_of(grown, 3).x(), 5) << "the trunk is bent";
    EXPECT_TRUE(grown.positions(grown.axes[4])[0].isApprox(tip_of(grown, 3), 1e-9));
    Vec3 const leans = grown.positions(grown.axes[4])[1] - grown.positions(grown.axes[4])[0];
    EXPECT_GT(leans.x(), 1) << "the part rides on its end";
}

TEST(Grafts, StandTurnedAndApartAsTheyWereSet)
{
    Two const two;
    auto edit = two.on(3, { 0, kPi / 2, 0 });
    edit.base_mm = { 0, 2, 0 };
    auto const scene = after({ edit }, two.scene);
    auto const trunk = scene.base->positions(scene.base->axes[4]);
    EXPECT_EQ(trunk[0], Vec3(0, 0, 400));
    EXPECT_TRUE(trunk[1].isApprox(Vec3(100, 2, 400), 1e-9)) << trunk[1].transpose();
    EXPECT_TRUE(trunk[4].isApprox(Vec3(400, 2, 400), 1e-9));
}

TEST(Grafts, AreRefusedWhereTheyMakeNoSense)
{
    Two const two;
    auto const refused = [&](GraftPlant const& edit) { return !apply_edit(two.scene, edit); };
    auto edit = two.on(3);
    edit.onto = two.guest;
    EXPECT_TRUE(refused(edit)) << "on itself";
    edit.onto = item_id(9, 0);
    EXPECT_TRUE(refused(edit));
    edit = two.on(3);
    edit.at.clear();
    EXPECT_TRUE(refused(edit));
    edit = two.on(3);
    edit.base_mm.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(refused(edit));
}

TEST(Grafts, WaitWhereTheirBranchIsGone)
{
    Two const two;
    auto scene = after({ two.on(9) }, two.scene); // The part is on the last branch.
    EXPECT_TRUE(scene.model_warnings.empty());
    LoadModel other { .source = { .name = "other.l",
                                  .text = "Lsystem: 1\nderivation length: 0\nAxiom: F(10)\n"
                                          "A --> A\nendlsystem\n" },
                      .drawn = Drawn::Keep };
    auto const without = after({ other }, scene);
    EXPECT_EQ(without.base->segment_count(), 1u);
    ASSERT_EQ(without.model_warnings.size(), 1u);
    EXPECT_NE(without.model_warnings[0].find("tree.l waits"), std::string::npos);
    auto again = tree();
    again.drawn = Drawn::Keep;
    EXPECT_EQ(after({ again }, without).base->segment_count(), 20u);
}

TEST(Grafts, ComeOffAsTheyWere)
{
    Two const two;
    auto const drawn = after(
        { select_paths(two.scene, { segments_of(two.scene.base->axes[2]) }), bend() }, two.scene);
    auto const grafted = after({ two.on(3) }, drawn);
    auto const off = after({ TakeOffGraft { two.host, two.guest, { 100, 0, 0 } } }, grafted);
    ASSERT_EQ(off.plants.size(), 2u);
    EXPECT_EQ(off.state.active, off.plants[1]->drawn->id);
    EXPECT_NE(off.state.active, two.guest) << "what names the old one is about the part";
    EXPECT_EQ(off.base->node_position_mm, drawn.base->node_position_mm);
    ASSERT_EQ(off.associations.size(), 1u);
    EXPECT_EQ(off.associations[0].what.path.vector(), drawn.associations[0].what.path.vector());
    EXPECT_TRUE(off.plants[0]->associations.empty());
    EXPECT_EQ(off.plants[0]->base->segment_count(), 10u);
    EXPECT_FALSE(apply_edit(off, TakeOffGraft { two.host, two.guest }));
}

TEST(Grafts, PartsOfPartsGoWithThem)
{
    Two two;
    two.scene = after({ tree({ 200, 0, 0 }) }, two.scene);
    auto const third = two.scene.state.active;
    auto const& guest = *two.scene.plants[1];
    auto scene = after(
        { GraftPlant { third, two.guest, guest.rest->addresses.address_of(*guest.base, 3) } },
        two.scene);
    EXPECT_EQ(scene.base->segment_count(), 20u);
    scene = after({ two.on(5) }, scene);
    EXPECT_EQ(scene.base->segment_count(), 30u);
    auto const& last = scene.base->axes[8];
    EXPECT_EQ(last.parent_segment, 13u) << "the tip of the guest's trunk";
    auto const off = after({ TakeOffGraft { two.host, two.guest } }, scene);
    EXPECT_EQ(off.base->segment_count(), 20u);
    EXPECT_EQ(off.plants[0]->base->segment_count(), 10u);
}

TEST(HiddenBranches, AreKeptWithWhatWasDrawnOnThem)
{
    auto scene = after({ SetScale { 1 }, tree() });
    auto const host = scene.state.active;
    auto const paths = variation::Selection { segments_of(scene.base->axes[1]),
                                              segments_of(scene.base->axes[2]) };
    scene = after({ select_paths(scene, paths), bend() }, scene);
    auto const at = scene.rest->addresses.address_of(*scene.base, paths[0].front());
    auto const hidden = after({ HideBranch { host, at } }, scene);
    EXPECT_EQ(hidden.base->segment_count(), 8u);
    ASSERT_EQ(hidden.associations.size(), 2u);
    EXPECT_TRUE(hidden.associations[0].what.is_orphaned);
    EXPECT_EQ(hidden.associations[1].what.path.vector(), segments_of(hidden.base->axes[1]))
        << "the next branch stays who it is";
    EXPECT_FALSE(apply_edit(hidden, HideBranch { host, at }));
    auto const shown = after({ HideBranch { host, at, false } }, hidden);
    EXPECT_EQ(shown.base->node_position_mm, scene.base->node_position_mm);
    EXPECT_FALSE(shown.associations[0].what.is_orphaned);
    EXPECT_FALSE(apply_edit(shown, HideBranch { host, at, false }));
}

// Whatever was grafted and hidden, the address of each segment must lead to that segment. Existing
// segments must keep their addresses.
RC_GTEST_PROP(Grafts, KeepAddresses, ())
{
    Two const two;
    auto const before = two.scene.plants[0];
    auto const host_address = [&](SegmentId segment) {
        return before->rest->addresses.address_of(*before->base, segment);
    };
    auto const last = static_cast<SegmentId>(before->base->segment_count());
    auto scene = after({ two.on(*rc::gen::inRange<SegmentId>(0, last)) }, two.scene);
    auto const hidden = *rc::gen::inRange<SegmentId>(0, 2 * last);
    scene = after(
        { HideBranch { two.host, scene.rest->addresses.address_of(*scene.base, hidden) } }, scene);
    check_plant(*scene.base);
    for (SegmentId segment = 0; segment < scene.base->segment_count(); ++segment) {
        auto const at = scene.rest->addresses.address_of(*scene.base, segment);
        RC_ASSERT(scene.rest->addresses.find_segment(*scene.base, at) == std::optional(segment));
        auto const path = scene.rest->addresses.address_of(*scene.base, std::vector { segment });
        RC_ASSERT(scene.rest->addresses.find_path(*scene.base, path)
                  == std::optional(std::vector { segment }));
    }
    for (SegmentId segment = 0; segment < last; ++segment)
        if (auto const found
            = scene.rest->addresses.find_segment(*scene.base, host_address(segment)))
            RC_ASSERT(tip_of(*scene.base, *found) == tip_of(*before->base, segment));
}

} // namespace
} // namespace tractus::scene
