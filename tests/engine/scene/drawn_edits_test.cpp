#include "engine/scene/scene.h"

#include "engine/plant/join_axes.h"
#include "engine/plant/skeleton_lines.h"
#include "engine/variation/growth.h"
#include "tests/engine/scene/edits.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::scene {
namespace {

// Returns a model of a trunk with six internodes and a branch with two. Optionally, the trunk has
// another branch below that one.
LoadModel model(bool has_branch, bool has_lower = false, Drawn drawn = Drawn::Keep)
{
    std::string const lower = has_lower ? "[-(50)F(9)]" : "";
    std::string const branch = has_branch ? "[+(60)F(8)F(8)]" : "";
    return { .source = { .name = "small.l",
                         .text = "Lsystem: 1\nderivation length: 1\nAxiom: F(10)" + lower + "F(10)"
                             + branch + "F(10)F(10)F(10)F(10)\nA --> A\nendlsystem\n" },
             .drawn = drawn };
}

Stroke stroke_to(Vec3 const& end)
{
    Stroke stroke;
    for (int i = 0; i <= 40; ++i) {
        double const along = i / 40.0;
        stroke.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                                .position_mm = Vec3(0, 0, 150 * along) + along * along * end,
                                .pressure = 0.5,
                                .touching = true });
    }
    return stroke;
}

// Returns a scene in which the branch was selected and a stroke was drawn for it.
Scene drawn_branch()
{
    auto const scene = after({ model(true) });
    return after(
        { Select { { segments_of(scene.base->axes[1]) } }, Associate { stroke_to({ 60, 40, 0 }) } },
        scene);
}

Plant plant_of(Scene scene)
{
    scene.growth.parameters.strength = 0;
    auto const plan = plan_growth(scene).value();
    return variation::Grower(plan).grow({});
}

TEST(DrawnEdits, AStrokeIsOrphanedWithItsBranchAndFoundAgain)
{
    auto const scene = drawn_branch();
    auto const drawn = plant_of(scene);

    auto const without = after({ model(false) }, scene);
    ASSERT_EQ(without.associations.size(), 1u);
    EXPECT_TRUE(without.associations[0].what.is_orphaned);
    EXPECT_EQ(plant_of(without).node_position_mm.size(), 7u);

    auto const again = after({ model(true) }, without);
    EXPECT_FALSE(again.associations[0].what.is_orphaned);
    EXPECT_EQ(plant_of(again).node_position_mm, drawn.node_position_mm);
    EXPECT_TRUE(after({ model(true, false, Drawn::Forget) }, scene).associations.empty());
}

TEST(DrawnEdits, AStrokeStaysWithItsBranchWhenOthersCome)
{
    auto const scene = after({ model(true, true) }, drawn_branch());
    ASSERT_FALSE(scene.associations[0].what.is_orphaned);
    // The new branch now comes first. The stroke must still be on the branch of two internodes.
    auto const path = scene.associations[0].what.path;
    ASSERT_EQ(path.size(), 2u);
    EXPECT_EQ(scene.base->axes[axis_of(*scene.base, path[0])].segment_count, 2u);
}

TEST(DrawnEdits, AnIndicatorOnABranchIsOrphanedToo)
{
    auto scene = drawn_branch();
    scene = after(
        { Indicate { { .end_mm = { 0, 100, 0 }, .below = { scene.selection[0].front() } } } },
        scene);
    auto const without = after({ model(false) }, scene);
    EXPECT_TRUE(without.indicators[0].what.is_orphaned);
    // Without its branch, the indicator must not affect the whole plant instead.
    for (auto const& node : plant_of(without).node_position_mm)
        EXPECT_EQ(node.y(), 0);
    auto const moved = after(
        { ChangeIndicator { .indicator = without.indicators[0].what }, model(true) }, without);
    EXPECT_FALSE(moved.indicators[0].what.is_orphaned);
    EXPECT_EQ(moved.indicators[0].what.below, scene.indicators[0].what.below);
}

TEST(DrawnEdits, TakingAStrokeAwayBringsTheEarlierBack)
{
    auto const first = drawn_branch();
    auto const second = after({ Associate { stroke_to({ -60, -40, 0 }) } }, first);
    EXPECT_EQ(selected_associations(second), (std::vector<std::size_t> { 1 }))
        << "the earlier one shapes nothing now";
    EXPECT_NE(plant_of(second).node_position_mm, plant_of(first).node_position_mm);
    auto const back = after({ DeleteStroke { numbered({ 1 }) } }, second);
    EXPECT_EQ(plant_of(back).node_position_mm, plant_of(first).node_position_mm);
    auto const none = after({ DeleteStroke { numbered({ 1, 0, 1 }) } }, second);
    EXPECT_TRUE(none.associations.empty());
}

TEST(DrawnEdits, RedrawingAPartMovesThePlant)
{
    auto const scene = drawn_branch();
    Stroke over; // A stroke that leads from the middle of the first stroke to another place.
    for (int i = 0; i <= 20; ++i)
        over.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                              .position_mm = Vec3(15, 10, 75) + i * Vec3(-5, 2, 0),
                              .touching = true });
    auto const redrawn = after({ Oversketch { numbered({ 0 }), over } }, scene);
    EXPECT_GT(redrawn.associations[0].what.stroke.tips.size(), 30u);
    EXPECT_GT((plant_of(redrawn).node_position_mm.back() - plant_of(scene).node_position_mm.back())
                  .norm(),
              1);
    for (auto& tip : over.tips.own())
        tip.position_mm.x() += 500;
    EXPECT_FALSE(apply_edit(scene, Oversketch { numbered({ 0 }), over }));
}

TEST(DrawnEdits, SmoothingTakesTheHandOut)
{
    auto const scene = after({ SmoothStroke { numbered({ 0 }), 0.25 } }, drawn_branch());
    EXPECT_EQ(scene.associations[0].what.detail_weight, 0.25);
    EXPECT_FALSE(apply_edit(scene, SmoothStroke { numbered({ 0 }), 7 }));
}

TEST(DrawnEdits, ErasingTheEndLaysTheBranchAlongWhatIsLeft)
{
    auto const scene = drawn_branch();
    auto const erased = after({ EraseTips { numbered({ 0 }), { { 21, 40 } } } }, scene);
    ASSERT_EQ(erased.associations.size(), 1u);
    ASSERT_EQ(erased.associations[0].what.stroke.tips.size(), 21u);
    auto short_stroke = stroke_to({ 60, 40, 0 });
    short_stroke.tips.own().resize(21);
    auto const drawn_short = after({ model(true), Select { { scene.associations[0].what.path } },
                                     Associate { short_stroke } });
    EXPECT_EQ(plant_of(erased).node_position_mm, plant_of(drawn_short).node_position_mm);
    EXPECT_NE(plant_of(erased).node_position_mm, plant_of(scene).node_position_mm);
}

TEST(DrawnEdits, AllBranchesOfAStrokeLoseTheSameTipsAndShareWhatIsLeft)
{
    auto scene = after({ model(true, true) });
    scene = after(
        { Select { { segments_of(scene.base->axes[1]), segments_of(scene.base->axes[2]) } },
          Associate { stroke_to({ 60, 40, 0 }) }, SmoothStroke { numbered({ 0, 1 }), 0.5 } },
        scene);
    auto const erased
        = after({ EraseTips { numbered({ 1, 0, 1 }), { { 0, 4 }, { 10, 12 } } } }, scene);
    ASSERT_EQ(erased.associations.size(), 2u);
    for (auto const& [id, association, at] : erased.associations) {
        EXPECT_EQ(association.stroke.tips.size(), 33u);
        EXPECT_EQ(association.detail_weight, 0.5);
    }
    EXPECT_EQ(erased.associations[0].what.stroke.tips.data(),
              erased.associations[1].what.stroke.tips.data());
    EXPECT_EQ(scene.associations[0].what.stroke.tips.size(), 41u) << "an earlier scene stays";
}

TEST(DrawnEdits, ErasingRefusesToLeaveWhatShapesNothing)
{
    auto const scene = drawn_branch();
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({ 0 }), { { 0, 40 } } }));
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({ 0 }), { { 1, 40 } } }));
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({ 0 }), { { 30, 41 } } }));
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({ 0 }), {} }));
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({ 1 }), { { 0, 1 } } }));
    EXPECT_FALSE(apply_edit(scene, EraseTips { numbered({}), { { 0, 1 } } }));
    // The stroke returns to its beginning, and only its last tips lead away from there. Without
    // these tips it has no chord.
    Stroke loop;
    for (double const x : { 0.0, 10.0, 20.0, 10.0, 0.0, -10.0 })
        loop.tips.push_back({ .position_mm = { x, std::abs(x - 5), 0 }, .touching = true });
    loop.tips.own()[4].position_mm = loop.tips[0].position_mm;
    auto const by_chord
        = after({ Associate { .stroke = loop, .fit = variation::StrokeFit::Chord } }, scene);
    EXPECT_FALSE(apply_edit(by_chord, EraseTips { numbered({ 1 }), { { 5, 5 } } }));
    EXPECT_TRUE(apply_edit(by_chord, EraseTips { numbered({ 1 }), { { 4, 5 } } }));
}

TEST(DrawnEdits, IndicatorsAreMovedAndDeleted)
{
    auto scene = after(
        { Indicate { { .end_mm = { 100, 0, 0 } } }, Indicate { { .end_mm = { 0, 100, 0 } } } },
        drawn_branch());
    scene = after({ ChangeIndicator { .number = 1, .indicator = { .end_mm = { 0, 0, 50 } } } },
                  scene);
    EXPECT_EQ(scene.indicators[1].what.end_mm, Vec3(0, 0, 50));
    scene = after({ DeleteIndicator { .number = 0 } }, scene);
    ASSERT_EQ(scene.indicators.size(), 1u);
    EXPECT_EQ(scene.indicators[0].what.end_mm, Vec3(0, 0, 50));
}

TEST(DrawnEdits, RefuseNumbersThatNothingHas)
{
    auto const scene = drawn_branch();
    auto const error = [&](Edit const& edit) { return apply_edit(scene, edit).error().message; };
    EXPECT_EQ(error(DeleteStroke { numbered({ 1 }) }), "there is no stroke 2: the scene has 1");
    EXPECT_EQ(error(DeleteStroke {}), "no stroke is chosen: select a branch that has been drawn");
    EXPECT_EQ(error(SmoothStroke { numbered({ 3 }) }), "there is no stroke 4: the scene has 1");
    EXPECT_EQ(error(DeleteIndicator { .number = 0 }),
              "there is no motion indicator 1: the scene has 0");
    EXPECT_FALSE(apply_edit(scene, Indicate { { .below = { 99 } } }));
}

TEST(DrawnEdits, ASkeletonOfAnotherProgramIsAPlantLikeAnother)
{
    std::vector<SkeletonPiece> const pieces { { { 0, 0, 0 }, { 0, 0, 100 } },
                                              { { 0, 0, 100 }, { 0, 0, 200 } },
                                              { { 0, 0, 100 }, { 60, 0, 140 } } };
    auto const scene = after({ LoadSkeleton { "tree.obj", pieces }, Select { { { 0, 1 } } },
                               Associate { stroke_to({ 80, 0, 0 }) } });
    EXPECT_EQ(scene.model_name, "tree.obj");
    EXPECT_GT(plant_of(scene).node_position_mm[2].x(), 20);
}

// Returns an edit that loads a measured tree: a trunk of two cylinders, with a branch on the lower
// one.
LoadMeasured measured(std::string const& more = "")
{
    return { .name = "tree.csv",
             .text = "id,parent,start_x,start_y,start_z,end_x,end_y,end_z,radius\n"
                     "1,0,500,200,10,500,200,11,0.1\n2,1,500,200,11,500,200,12,0.08\n"
                     "3,1,500,200,11,500.6,200,11.4,0.03\n"
                 + more,
             .format = LoadMeasured::Format::Qsm,
             .drawn = Drawn::Keep };
}

TEST(DrawnEdits, AMeasuredTreeIsAPlantLikeAnother)
{
    auto const bare = after({ measured() });
    EXPECT_EQ(bare.model_name, "tree.csv");
    ASSERT_EQ(bare.base->axes.size(), 2u);
    // The tree is two metres high. It must be shown at the height of the drawing volume.
    EXPECT_NEAR(bare.placement.scale * 2000, DrawingVolume().height_mm, 1e-6);

    auto const scene = after(
        { Select { { segments_of(bare.base->axes[1]) } }, Associate { stroke_to({ 60, 40, 0 }) } },
        bare);
    auto const drawn = plant_of(scene);
    EXPECT_GT((drawn.node_position_mm.back() - bare.base->node_position_mm.back()).norm(), 100);

    // If more of the same tree was measured, the branch must be found again in it.
    auto const grown = after({ measured("4,2,500,200,12,500,200,13,0.05\n") }, scene);
    ASSERT_EQ(grown.associations.size(), 1u);
    EXPECT_FALSE(grown.associations[0].what.is_orphaned);
    EXPECT_EQ(grown.base->segment_count(), 4u);
}

TEST(DrawnEdits, AMeasuredTreeThatIsNoneChangesNothing)
{
    auto const scene = after({ measured() });
    EXPECT_EQ(apply_edit(scene, measured("5,x,1,1,1,1,1,1,1\n")).error().message,
              "tree.csv:5: found x in column 2, expected a number");
}

// A session file may come from an untrusted author, so its times may be arbitrary.
TEST(DrawnEdits, AreDescribedWhateverTheirTimes)
{
    Associate edit { stroke_towards({ 0, 0, 0 }) };
    edit.stroke.tips.own().front().time = timestamp_ns(std::numeric_limits<std::int64_t>::min());
    edit.stroke.tips.own().back().time = timestamp_ns(std::numeric_limits<std::int64_t>::max());
    EXPECT_NE(Edit(edit).describe().find("in 18446744073.7 s"), std::string::npos)
        << Edit(edit).describe();
}

} // namespace
} // namespace tractus::scene
