#include "tests/engine/scene/limbs.h"

#include <optional>
#include <rapidcheck/gtest.h>
#include <utility>

namespace tractus::scene {
namespace {

TEST(Limbs, BearLimbsAndGoWithWhatBearsThem)
{
    auto const tree = tree_scene();
    auto scene = after({ on_segment(tree, 2, winding({ 0, 0, 300 }, 300)) }, tree);
    auto const first = limb_axis(scene).first_segment + 20;
    scene = after({ on_segment(scene, first, winding({ 200, 0, 330 }, 120)) }, scene);
    check_plant(*scene.base);
    auto const limbs = limb_segments(scene);
    ASSERT_EQ(limbs.size(), 2u);
    EXPECT_EQ(limb_axis(scene, 1).parent_segment, first);
    EXPECT_EQ(limb_axis(scene, 1).order, 2u);
    auto const address = scene.rest->addresses.address_of(*scene.base, limbs[1].second);
    EXPECT_EQ(limb_at(*scene.drawn, address), limbs[1].first->limb->id);
    EXPECT_EQ(limb_at(*scene.drawn, scene.rest->addresses.address_of(*scene.base, 3)), 0u);
    EXPECT_EQ(scene.base->materials.size(), tree.base->materials.size()) << "no looks twice";
    scene = after({ select_paths(scene, { segments_of(limb_axis(scene, 1)) }),
                    shaping(variation::Propagation::Selected) },
                  scene);
    auto const none = after(
        { EraseLimb { scene.state.active, limb_segments(scene)[0].first->limb->id } }, scene);
    EXPECT_EQ(none.base->node_position_mm, tree.base->node_position_mm);
    EXPECT_TRUE(none.associations.empty());
    EXPECT_TRUE(none.selection.empty());
    EXPECT_TRUE(none.drawn->grafts.empty());
}

TEST(Limbs, GoWithAGraftThatIsTakenOff)
{
    auto host = leafy_tree();
    host.drawn = Drawn::Beside;
    auto scene = after({ SetScale { 1 }, host, host });
    auto const first = scene.plants[0]->drawn->id;
    auto const second = scene.plants[1]->drawn->id;
    scene = after({ on_segment(scene, 2, winding({ 0, 0, 300 }, 300)) }, scene);
    auto const alone = scene.base->node_position_mm;
    scene = after(
        { GraftPlant { second, first,
                       scene.plants[0]->rest->addresses.address_of(*scene.plants[0]->base, 5) } },
        scene);
    ASSERT_EQ(limb_segments(scene).size(), 1u);
    auto const on_guest = axis_of(*scene.base, limb_segments(scene)[0].second);
    EXPECT_EQ(scene.base->axes[on_guest].order, 2u);
    auto const guest_branch
        = scene.base->axes[scene.base->axes[on_guest].parent_axis].first_segment + 4;
    scene = after({ on_segment(scene, guest_branch, winding({ 0, 0, 1100 }, 300)) }, scene);
    EXPECT_EQ(limb_segments(scene).size(), 2u);
    auto const off = after({ TakeOffGraft { first, second } }, scene);
    EXPECT_EQ(limb_segments(*off.plants[1]).size(), 2u);
    EXPECT_TRUE(limb_segments(*off.plants[0]).empty());
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), off.base->node_position_mm.begin()));
}

TEST(Limbs, WaitOnHiddenBranchesAndMoveDownWhereTheirBranchIsShorter)
{
    auto const tree = tree_scene();
    auto const branch = tree.base->axes[1].first_segment;
    auto const scene = after({ on_segment(tree, branch + 6, winding({ 0, 0, 300 }, 200)) }, tree);
    auto const hidden = after(
        { HideBranch { tree.state.active, tree.rest->addresses.address_of(*tree.base, branch) } },
        scene);
    EXPECT_TRUE(limb_segments(hidden).empty());
    ASSERT_EQ(hidden.model_warnings.size(), 1u);
    EXPECT_NE(hidden.model_warnings[0].find("waits"), std::string::npos);
    auto shorter = leafy_tree();
    shorter.drawn = Drawn::Keep;
    auto& text = shorter.source.text;
    text.erase(text.rfind("F(4)[#(.4)+(50)F(2)]"),
               text.find("endlsystem") - text.rfind("F(4)[#(.4)+(50)F(2)]") - 1);
    auto const moved = after({ shorter }, scene);
    check_plant(*moved.base);
    ASSERT_EQ(limb_segments(moved).size(), 1u);
    auto const& bearer = moved.base->axes[limb_axis(moved).parent_axis];
    EXPECT_EQ(bearer.first_segment, moved.base->axes[1].first_segment);
    EXPECT_EQ(limb_axis(moved).parent_segment, bearer.first_segment + bearer.segment_count - 1);
    auto back = leafy_tree();
    back.drawn = Drawn::Keep;
    EXPECT_EQ(after({ back }, moved).base->node_position_mm, scene.base->node_position_mm);
}

TEST(Limbs, AreRefusedWhereTheyMakeNoSense)
{
    auto const tree = tree_scene();
    auto const good = on_segment(tree, 2, winding({ 0, 0, 300 }, 200));
    auto const refused = [&](DrawLimb const& edit) {
        auto const result = apply_edit(tree, edit);
        return !result && !result.error().message.empty() && result.error().fault == Fault::User;
    };
    double const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(refused(good));
    auto edit = good;
    edit.at.clear();
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.joint = 1.5;
    EXPECT_TRUE(refused(edit));
    edit.joint = nan;
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.joint_mm.y() = nan;
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.scale = 0;
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.width_mm = -1;
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.scale = 1e-300;
    EXPECT_TRUE(refused(edit)) << "farther than any branch";
    edit.scale = 1e300;
    EXPECT_TRUE(refused(edit)) << "a point";
    edit = good;
    edit.at = { 0, 4'000'000'000 };
    EXPECT_FALSE(refused(edit)) << "where the trunk is shorter now: at its tip";
    edit.at = { 1, 2, 3 };
    EXPECT_FALSE(refused(edit)) << "it waits";
    edit = good;
    edit.plant = 999;
    EXPECT_TRUE(refused(edit));
    edit = good;
    edit.stroke = stroke_of({ { 1, 2, 3 }, { 1, 2, 3 } });
    EXPECT_TRUE(refused(edit));
    edit.stroke = stroke_of({ { 1, 2, 3 }, { nan, 2, 3 } });
    EXPECT_TRUE(refused(edit));
    EXPECT_FALSE(apply_edit(tree, EraseLimb { tree.state.active, 5 }));
    auto const scene = after({ good }, tree);
    auto const off = apply_edit(
        scene, TakeOffGraft { scene.state.active, limb_segments(scene)[0].first->limb->id });
    ASSERT_FALSE(off);
    EXPECT_NE(off.error().message.find("erase it"), std::string::npos);
}

// Whatever is drawn and wherever, the plant must be valid, and its existing segments must keep
// their addresses.
RC_GTEST_PROP(Limbs, KeepThePlantSound, ())
{
    auto scene = tree_scene();
    auto const count = *rc::gen::inRange(1, 4);
    for (int i = 0; i < count; ++i) {
        auto const segment
            = *rc::gen::inRange<SegmentId>(0, static_cast<SegmentId>(scene.base->segment_count()));
        std::vector<Vec3> places_mm;
        for (int k = *rc::gen::inRange(2, 9); k > 0; --k)
            places_mm.emplace_back(*rc::gen::inRange(-300, 300), *rc::gen::inRange(-300, 300),
                                   *rc::gen::inRange(-50, 900));
        auto const edit = on_segment(scene, segment, places_mm);
        auto next = apply_edit(scene, edit);
        RC_PRE(bool(next)); // The drawing of a limb may fail, since all of its points may be equal.
        auto const before = std::exchange(scene, *std::move(next));
        check_plant(*scene.base);
        RC_ASSERT(limb_segments(scene).size() == static_cast<std::size_t>(i) + 1);
        for (SegmentId id = 0; id < scene.base->segment_count(); ++id) {
            auto const at = scene.rest->addresses.address_of(*scene.base, id);
            RC_ASSERT(scene.rest->addresses.find_segment(*scene.base, at) == std::optional(id));
            if (id < before.base->segment_count())
                RC_ASSERT(at == before.rest->addresses.address_of(*before.base, id));
        }
    }
}

} // namespace
} // namespace tractus::scene
