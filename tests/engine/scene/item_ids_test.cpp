#include "engine/scene/edit_ids.h"

#include "engine/plant/join_axes.h"
#include "engine/scene/scene.h"
#include "tests/engine/scene/edits.h"

namespace tractus::scene {
namespace {

LoadModel trunk_with_branches(std::string const& below = "")
{
    return { .source = { .name = "small.l",
                         .text = "Lsystem: 1\nderivation length: 1\nAxiom: F(10)" + below
                             + "F(10)[+(60)F(8)F(8)]F(10)[-(60)F(8)F(8)]F(10)\nA --> A\n"
                               "endlsystem\n" },
             .drawn = Drawn::Keep };
}

variation::Selection axes_of(Plant const& plant, std::initializer_list<std::size_t> axes)
{
    variation::Selection paths;
    for (auto const axis : axes)
        paths.push_back(segments_of(plant.axes[axis]));
    return paths;
}

// Returns a scene with strokes on the trunk, on both branches at once, and on the trunk again. They
// are the edits 3, 5 and 7.
Scene drawn()
{
    auto const scene = after({ trunk_with_branches() });
    auto const& plant = *scene.base;
    return after(
        { select_paths(scene, axes_of(plant, { 0 })), Associate { stroke_towards({ 40, 0, 0 }) },
          select_paths(scene, axes_of(plant, { 1, 2 })), Associate { stroke_towards({ 0, 40, 0 }) },
          select_paths(scene, axes_of(plant, { 0 })), Associate { stroke_towards({ -40, 0, 0 }) } },
        scene);
}

TEST(ItemIds, TellTheEditThatMadeAnItem)
{
    auto const scene = drawn();
    ASSERT_EQ(scene.associations.size(), 4u);
    EXPECT_EQ(name_of(scene.associations[0].id), "3");
    EXPECT_EQ(name_of(scene.associations[1].id), "5");
    EXPECT_EQ(name_of(scene.associations[2].id), "5.2");
    EXPECT_EQ(name_of(scene.associations[3].id), "7");
    EXPECT_EQ(list_names({ item_id(3, 0), item_id(5, 1), item_id(7, 0) }), "3, 5.2 and 7");
}

// If two erasers are used at once, the effect of one must not change which strokes the other one
// names.
TEST(ItemIds, MeanTheSameStrokeWhateverElseIsTakenAway)
{
    auto const scene = drawn();
    DeleteStroke const first { { .ids = { scene.associations[0].id } } };
    DeleteStroke const last { { .ids = { scene.associations[3].id } } };
    for (auto const& edits : { std::vector<Edit> { first, last }, { last, first } }) {
        auto const left = after(edits, scene);
        ASSERT_EQ(left.associations.size(), 2u);
        EXPECT_EQ(left.associations[0].id, item_id(5, 0));
        EXPECT_EQ(left.associations[1].id, item_id(5, 1));
    }
    auto const again = apply_edit(after({ first }, scene), first);
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().message, "there is no stroke 3 any more");
}

TEST(ItemIds, AreNeverGivenAgain)
{
    auto scene = drawn();
    auto const last = scene.associations[3].id;
    scene = after(
        { DeleteStroke { { .ids = { last } } }, Associate { stroke_towards({ 9, 0, 0 }) } }, scene);
    EXPECT_GT(scene.associations[3].id, last);
}

// If a repair removes an edit from a session, the remaining strokes must keep their ids.
TEST(ItemIds, GoWithTheirEdit)
{
    auto const scene = after({ trunk_with_branches() });
    auto const select = select_paths(scene, axes_of(*scene.base, { 0 }));
    auto const kept = with_id(Associate { stroke_towards({ 5, 0, 0 }) }, 40);
    auto const drawn = after({ select, kept, Associate { stroke_towards({ 6, 0, 0 }) } }, scene);
    EXPECT_EQ(drawn.associations[0].id, item_id(40, 0));
    EXPECT_EQ(drawn.associations[1].id, item_id(41, 0));
    EXPECT_EQ(with_id(kept, 9).get<Associate>()->id, item_id(40, 0)) << "it has one";
}

TEST(ItemIds, ChangeTheIndicatorThatIsMeant)
{
    auto scene = after({ trunk_with_branches() });
    auto const branch = segments_of(scene.base->axes[1]).front();
    scene
        = after({ Indicate { { .end_mm = { 100, 0, 0 } } },
                  Indicate { .indicator = { .end_mm = { 0, 100, 0 } },
                             .below = { scene.rest->addresses.address_of(*scene.base, branch) } } },
                scene);
    auto const second = scene.indicators[1].id;
    EXPECT_EQ(name_of(second), "3");
    EXPECT_EQ(scene.indicators[1].what.below, std::vector<SegmentId> { branch });
    scene = after({ DeleteIndicator { scene.indicators[0].id },
                    ChangeIndicator { .which = second, .indicator = { .end_mm = { 0, 0, 50 } } } },
                  scene);
    ASSERT_EQ(scene.indicators.size(), 1u);
    EXPECT_EQ(scene.indicators[0].what.end_mm, Vec3(0, 0, 50));
    EXPECT_EQ(scene.indicators[0].what.below, std::vector<SegmentId> { branch })
        << "it stays there";
}

// If a branch is added further down, the segments get other numbers. An address must still lead to
// the same place.
TEST(Places, AreFoundInAPlantThatHasChangedElsewhere)
{
    auto const before = after({ trunk_with_branches() });
    auto const upper = segments_of(before.base->axes[2]);
    auto const select = select_paths(before, { upper });
    auto const scene = after({ trunk_with_branches("[+(30)F(9)F(9)F(9)]"), select });
    ASSERT_EQ(scene.selection.size(), 1u);
    EXPECT_NE(scene.selection[0], upper);
    EXPECT_EQ(parent_segment(*scene.base, scene.selection[0].front()),
              scene.base->axes[0].first_segment + 2);
}

// The selection may refer to a place that the plant does not have, if the model has changed since
// the session was drawn. That part of the selection must wait.
TEST(Places, ThatThePlantHasNotWait)
{
    auto const scene = after({ trunk_with_branches(), Select { .at = { { { 0, 0 }, { 0, 99 } } } },
                               Associate { stroke_towards({ 40, 0, 0 }) } });
    EXPECT_TRUE(scene.selection.empty());
    ASSERT_EQ(scene.associations.size(), 1u);
    EXPECT_TRUE(scene.associations[0].what.is_orphaned);
}

} // namespace
} // namespace tractus::scene
