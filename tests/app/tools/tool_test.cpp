#include "app/tools/tool.h"

#include "app/document/draw.h"
#include "app/methods/all_methods.h"
#include "app/methods/indicators/delete_indicator_tool.h"
#include "app/methods/indicators/indicate_tool.h"
#include "app/methods/indicators/move_indicator_tool.h"
#include "app/methods/indicators/turn_indicator_tool.h"
#include "app/tools/delete_tool.h"
#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "app/tools/erase_tool.h"
#include "app/tools/limb_tool.h"
#include "app/tools/oversketch_tool.h"
#include "app/tools/select_tool.h"
#include "app/tools/smooth_tool.h"
#include "app/tools/turn_stroke_tool.h"
#include "app/tools/underground.h"
#include "engine/plant/join_axes.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"
#include "tests/app/small_model.h"
#include "tests/engine/scene/edits.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::tools {
namespace {

using SelectionMode = SelectTool::SelectionMode;
using EraseExtent = EraseTool::EraseExtent;

ToolKinds tools()
{
    return methods::all_methods().tools;
}

Result<std::vector<scene::Edit>> edits_of(Tool const& tool, Stroke const& stroke,
                                          scene::Scene const& scene)
{
    return tool.edits_for(stroke, scene);
}

TEST(Tool, IsReadAndWrittenAsWords)
{
    std::vector<Tool> const some {
        SelectTool {},
        indicators::IndicateTool {},
        DrawInOrderTool {},
        DrawTool {},
        DrawTool { variation::Propagation::Descendants },
        DrawTool { variation::Propagation::Both },
        EraseTool {},
        EraseTool { EraseTool::EraseExtent::Part },
        Tool(SmoothTool {}).done_at_once(),
        Tool(SelectTool { SelectionMode::Ends })
            .seen_from({ 30, -12.5, 2, { 10, -4 }, { 152, 95 } }),
    };
    for (auto const& tool : some) {
        auto const words = words_for(tool);
        EXPECT_EQ(parse_tool(tools(), words.name, words.arguments).value(), tool) << words.name;
    }
}

TEST(Tool, NamesTheToolsThereAre)
{
    EXPECT_NE(parse_tool(tools(), "hammer", "")
                  .error()
                  .message.find("draw_in_order, draw, draw_limb, oversketch"),
              std::string::npos);
    EXPECT_NE(parse_tool(tools(), "draw", "now").error().message.find("needs a stroke"),
              std::string::npos);
    for (auto const* view : { "view=1,2", "view=0,90,1,0,0,254,159", "view=0,0,1,0,0,254,159,3",
                              "view=0,0,nan,0,0,254,159", "view=0,0,1,0,0,254,15 9" })
        EXPECT_FALSE(parse_tool(tools(), "select", view)) << view;
    EXPECT_NE(parse_tool(tools(), "draw", "everything")
                  .error()
                  .message.find("selected, descendants, both"),
              std::string::npos);
}

// Returns the position, on the tablet, at which the selection view shows a point of the plant.
Vec3 shown(scene::Scene const& scene, Vec3 const& plant_mm)
{
    auto const view = scene::fit_selection_view(*scene.base);
    auto const place = view.tablet_of_plant(plant_mm);
    return { place.x(), place.y(), 40 };
}

TEST(SelectTool, SelectsTheAxisThatThePenFollows)
{
    auto const scene = small_scene();
    auto const nodes = scene.base->positions(scene.base->axes[0]);
    auto const stroke = stroke_through({ shown(scene, nodes.front() + Vec3(0, 0, 20)),
                                         shown(scene, nodes.back() - Vec3(0, 0, 20)) });
    auto const edits = edits_of(SelectTool {}, stroke, scene);
    ASSERT_TRUE(edits) << edits.error().message;
    ASSERT_EQ(edits->size(), 1u);
    EXPECT_EQ(scene::after(*edits, scene).selection,
              variation::Selection { segments_of(scene.base->axes[0]) });
}

// A branch is selected where it is shown, as bent by strokes. In logs without this option, the tool
// selects on the rest shape, as in older versions.
TEST(SelectTool, ChoosesOnTheSkeletonAsBentWhereItSaysSo)
{
    auto scene = small_scene();
    auto const trunk = segments_of(scene.base->axes[0]);
    select(scene, { trunk });
    scene = scene::apply_edit(
                scene,
                scene::Associate { .stroke = stroke_through({ { 0, 0, 0 }, { 100, 0, 10 } }),
                                   .fit = variation::StrokeFit::World })
                .value();
    std::vector<Vec3> nodes_mm;
    scene::SceneShaper shaper;
    ASSERT_TRUE(shaper.set_plant(scene));
    variation::place_nodes(*scene.base, *scene.rest, shaper.shape(), nodes_mm);
    auto const stroke = stroke_through(
        { shown(scene, 0.8 * nodes_mm[0] + 0.2 * nodes_mm[1]), shown(scene, nodes_mm[5]) });
    EXPECT_FALSE(edits_of(SelectTool {}, stroke, scene)) << "at rest it stands upright";
    auto const bent
        = Tool(SelectTool {}).seen_from({ .shape = scene::SelectionAngle::Shape::AsBent });
    auto const edits = bent.edits_for(stroke, scene);
    ASSERT_TRUE(edits) << edits.error().message;
    EXPECT_EQ(scene::after(*edits, scene).selection[0].front(), trunk.front());
    EXPECT_EQ(words_for(bent).arguments, "bent");
    EXPECT_EQ(parse_tool(tools(), "select", "bent").value(), bent);
    auto const both = parse_tool(tools(), "select", "bent view=30,0,1,0,0,254,159").value();
    EXPECT_EQ(words_for(both).arguments,
              "view=30.0000,0.0000,1.0000,0.0000,0.0000,254.0000,159.0000 bent");
    EXPECT_FALSE(parse_tool(tools(), "draw", "bent"));
}

TEST(SelectTool, SaysThatAStrokeWentBesideThePlant)
{
    auto const scene = small_scene();
    auto const stroke = stroke_through({ { -120, 70, 0 }, { -120, 40, 0 } });
    auto const edits = edits_of(SelectTool {}, stroke, scene);
    ASSERT_FALSE(edits);
    EXPECT_EQ(edits.error().fault, Fault::User);
}

TEST(DrawTool, ShapesWhatIsSelected)
{
    auto scene = small_scene();
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } });
    EXPECT_FALSE(edits_of(DrawTool {}, stroke, scene));
    select(scene, { segments_of(scene.base->axes[1]) });
    auto const edits = edits_of(DrawTool { variation::Propagation::Both }, stroke, scene);
    ASSERT_TRUE(edits);
    EXPECT_EQ((*edits)[0].get<scene::Associate>()->propagation, variation::Propagation::Both);
}

TEST(DrawTool, LaysByHeadingInHandAndByLeastTwistInOlderLogs)
{
    using variation::StrokeLaying;
    EXPECT_EQ(DrawTool {}.laying, StrokeLaying::HeadingAndPitch);
    EXPECT_EQ(DrawInOrderTool {}.laying, StrokeLaying::HeadingAndPitch);
    EXPECT_EQ(words_for(DrawTool { variation::Propagation::Both }).arguments,
              "both heading from_foot");
    EXPECT_EQ(parse_tool(tools(), "draw", "both")->get<DrawTool>()->laying,
              StrokeLaying::LeastTwist);
    EXPECT_EQ(default_tool_of_kind(DrawInOrderTool::kKind).get<DrawInOrderTool>()->laying,
              StrokeLaying::LeastTwist);
    EXPECT_EQ(words_of_selected_tool(tools(), "draw", "both chord"),
              "both chord heading from_foot");
    EXPECT_EQ(words_of_selected_tool(tools(), "draw", "both least_twist"),
              "both least_twist from_foot");
    EXPECT_EQ(words_of_selected_tool(tools(), "draw_in_order", ""), "heading from_foot");
    EXPECT_EQ(words_of_selected_tool(tools(), "select", "path"), "path");
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[1]) });
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 60, 0, -30 } });
    auto const edits = edits_of(DrawTool {}, stroke, scene);
    ASSERT_TRUE(edits);
    EXPECT_EQ((*edits)[0].get<scene::Associate>()->laying, StrokeLaying::HeadingAndPitch);
}

TEST(DrawTool, SaysWhatItHasBentBelowTheGround)
{
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[0]) });
    auto const drawn = [&](Vec3 const& end) {
        auto const edits = edits_of(DrawTool {}, stroke_through({ { 0, 0, 0 }, end }), scene);
        return scene::after(*edits, scene);
    };
    EXPECT_EQ(underground_message(DrawTool {}, drawn({ 10, 0, 100 })), "");
    auto const below = drawn({ 10, 0, -100 });
    EXPECT_TRUE(
        underground_message(DrawTool {}, below).starts_with("The stroke shapes the branch; "));
    EXPECT_NE(underground_message(DrawTool {}, below).find("are below the ground"),
              std::string::npos);
    auto const lines = kUndergroundLayer.lines(below);
    ASSERT_FALSE(lines.empty());
    EXPECT_LT(lines.front().back().z(), below.placement.world_of_plant(Vec3::Zero()).z());
}

TEST(IndicateTool, TakesTheEndsOfTheStroke)
{
    auto const stroke = stroke_through({ { 0, 0, 100 }, { 30, 50, 100 }, { 80, 0, 120 } });
    auto const edits = edits_of(indicators::IndicateTool {}, stroke, small_scene()).value();
    EXPECT_EQ(edits[0].get<scene::Indicate>()->indicator.start_mm, Vec3(0, 0, 100));
    EXPECT_EQ(edits[0].get<scene::Indicate>()->indicator.end_mm, Vec3(80, 0, 120));
}

TEST(DrawInOrderTool, ShapesTheTrunkFirstAndThenTheLongestBranch)
{
    auto scene = small_scene();
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } });
    std::vector<AxisId> drawn;
    for (int turn = 0; turn < 4; ++turn) {
        auto const edits = edits_of(DrawInOrderTool {}, stroke, scene).value();
        for (auto const& edit : edits)
            scene = scene::apply_edit(scene, edit).value();
        drawn.push_back(axis_of(*scene.base, scene.selection[0][0]));
    }
    auto const order = axes_in_drawing_order(*scene.base);
    EXPECT_EQ(drawn, (std::vector<AxisId> { order[0], order[1], order[2], order[0] }));
    EXPECT_EQ(scene.base->axes[order[1]].segment_count, 4u);
}

variation::Selection selection_by(SelectionMode selecting, Stroke const& stroke,
                                  scene::Scene const& scene)
{
    auto const edits = edits_of(SelectTool { selecting }, stroke, scene);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::after(*edits, scene).selection.vector() : variation::Selection {};
}

TEST(Tool, KnowsAllItsArguments)
{
    for (auto const* arguments : { "add", "take", "ends", "order", "alike", "invert", "nothing" }) {
        auto const tool = parse_tool(tools(), "select", arguments).value();
        EXPECT_EQ(words_for(tool).arguments, arguments);
    }
    for (auto const* arguments : { "both world", "descendants chord", "chord" }) {
        auto const tool = parse_tool(tools(), "draw", arguments).value();
        EXPECT_EQ(words_for(tool).arguments, arguments);
    }
    for (auto const* arguments : { "below", "near", "near light", "light" })
        EXPECT_EQ(words_for(parse_tool(tools(), "indicate", arguments).value()).arguments,
                  arguments);
    EXPECT_EQ(parse_tool(tools(), "draw", "world both").value(),
              parse_tool(tools(), "draw", "both world").value());
    EXPECT_EQ(parse_tool(tools(), "smooth", "much").error().message,
              "the tool smooth takes no \"much\": leave it out");
}

TEST(SelectTool, ChoosesInAllWays)
{
    // The model has a trunk of six internodes, and two branches of four and two internodes.
    auto scene = small_scene();
    auto const& plant = *scene.base;
    auto const tip_of = [&](AxisId id) { return plant.positions(plant.axes[id]).back(); };
    auto const along = [&](Vec3 const& from, Vec3 const& to) {
        return stroke_through({ shown(scene, from), shown(scene, to) });
    };
    auto const trunk = segments_of(plant.axes[0]);
    auto const first = segments_of(plant.axes[1]);
    auto const second = segments_of(plant.axes[2]);

    // A straight stroke from the middle of the trunk's first internode to the tip of a branch. In
    // between, it touches no branch.
    auto const base = plant.positions(plant.axes[0])[1] * 0.5;
    auto const path = selection_by(SelectionMode::Ends, along(base, tip_of(2)), scene);
    ASSERT_EQ(path.size(), 1u);
    EXPECT_EQ(path[0].front(), trunk[0]);
    EXPECT_EQ(path[0].back(), second.back());

    auto const touch = along(tip_of(1) + Vec3(0, 0, 1), tip_of(1));
    EXPECT_EQ(selection_by(SelectionMode::Order, touch, scene),
              (variation::Selection { first, second }));
    EXPECT_EQ(selection_by(SelectionMode::Alike, touch, scene),
              (variation::Selection { first, second }));
    select(scene, { trunk });
    EXPECT_EQ(selection_by(SelectionMode::Invert, touch, scene),
              (variation::Selection { first, second }));
    EXPECT_EQ(selection_by(SelectionMode::Nothing, touch, scene), variation::Selection {});
    EXPECT_EQ(selection_by(SelectionMode::Add, touch, scene).size(), 2u);
    select(scene, { first, second });
    auto const taken = selection_by(SelectionMode::Take,
                                    along(plant.positions(plant.axes[1])[1], tip_of(1)), scene);
    EXPECT_EQ(taken.back(), second);
    EXPECT_NE(taken.front(), first);
}

TEST(IndicateTool, MayActOnTheSelectedBranchOrNearTheStroke)
{
    auto scene = small_scene();
    auto const stroke = stroke_through({ { 0, 0, 100 }, { 80, 0, 120 } });
    Tool const below = indicators::IndicateTool { .reach = indicators::IndicateTool::Reach::Below };
    EXPECT_FALSE(edits_of(below, stroke, scene));
    select(scene, { segments_of(scene.base->axes[1]) });
    auto const edits = edits_of(below, stroke, scene).value();
    EXPECT_EQ(scene::after(edits, scene).indicators[0].what.below,
              std::vector<SegmentId> { scene.base->axes[1].first_segment });
    auto const near
        = edits_of(parse_tool(tools(), "indicate", "near light").value(), stroke, scene).value();
    EXPECT_NEAR(*near[0].get<scene::Indicate>()->indicator.reach_mm, std::hypot(80, 20), 1e-9);
    EXPECT_EQ(near[0].get<scene::Indicate>()->indicator.kind,
              variation::MotionIndicator::Kind::Light);
}

TEST(IndicatorTools, MoveAndDeleteTheOneWhereTheyBegin)
{
    auto scene = small_scene();
    scene = scene::after(
        { scene::Indicate { { .start_mm = { 0, 0, 100 }, .end_mm = { 100, 0, 100 } } } }, scene);
    auto const move = stroke_through({ { 50, 5, 100 }, { 50, 5, 160 } });
    auto const moved = edits_of(indicators::MoveIndicatorTool {}, move, scene).value();
    scene = scene::apply_edit(scene, moved[0]).value();
    EXPECT_EQ(scene.indicators[0].what.start_mm, Vec3(0, 0, 160));
    auto const touch = stroke_through({ { 50, 5, 160 }, { 50, 5, 160 } });
    auto const turned = edits_of(indicators::TurnIndicatorTool {}, touch, scene).value();
    scene = scene::apply_edit(scene, turned[0]).value();
    EXPECT_EQ(scene.indicators[0].what.start_mm, Vec3(100, 0, 160));
    EXPECT_EQ(scene.indicators[0].what.end_mm, Vec3(0, 0, 160));
    // The stroke begins beside the indicator's new position, so it deletes nothing.
    EXPECT_FALSE(edits_of(indicators::DeleteIndicatorTool {}, move, scene));
    auto const there = stroke_through({ { 90, 0, 161 }, { 95, 0, 161 } });
    scene = scene::apply_edit(scene,
                              edits_of(indicators::DeleteIndicatorTool {}, there, scene).value()[0])
                .value();
    EXPECT_TRUE(scene.indicators.empty());
}

TEST(StrokeTools, EditTheStrokesOfTheSelectedBranch)
{
    auto scene = small_scene();
    auto const up = stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } });
    for (auto const& tool : { Tool(OversketchTool {}), Tool(SmoothTool {}), Tool(TurnStrokeTool {}),
                              Tool(DeleteTool {}) })
        EXPECT_FALSE(edits_of(tool, up, scene));
    select(scene, { segments_of(scene.base->axes[0]) });
    EXPECT_TRUE(document::draw(up, DrawTool {}, scene).refusal.empty());
    EXPECT_TRUE(
        document::draw(stroke_through({ { 0, 0, 50 }, { 60, 0, 90 } }), OversketchTool {}, scene)
            .refusal.empty());
    EXPECT_EQ(scene.associations[0].what.stroke.tips.back().position_mm, Vec3(60, 0, 90));
    EXPECT_TRUE(document::draw(up, SmoothTool {}, scene).refusal.empty());
    EXPECT_EQ(scene.associations[0].what.detail_weight, 0);
    // Turning a stroke round twice restores the branch.
    auto const first_mm = scene.associations[0].what.stroke.tips.front().position_mm;
    EXPECT_TRUE(document::draw(up, TurnStrokeTool {}, scene).refusal.empty());
    EXPECT_EQ(scene.associations[0].what.stroke.tips.back().position_mm, first_mm);
    EXPECT_TRUE(scene.drawn->strokes[0].what.is_drawn_reversed);
    EXPECT_TRUE(document::draw(up, TurnStrokeTool {}, scene).refusal.empty());
    EXPECT_EQ(scene.associations[0].what.stroke.tips.front().position_mm, first_mm);
    EXPECT_FALSE(scene.drawn->strokes[0].what.is_drawn_reversed);
    EXPECT_TRUE(document::draw(up, DeleteTool {}, scene).refusal.empty());
    EXPECT_TRUE(scene.associations.empty());
    EXPECT_FALSE(document::draw(up, DeleteTool {}, scene).refusal.empty());
}

scene::Associate association_of(Stroke stroke)
{
    return { .stroke = std::move(stroke), .propagation = variation::Propagation::Both };
}

// Returns a scene with two strokes along x, the second one 50 mm above the first. The first stroke
// shapes one axis, and the second shapes two.
scene::Scene scene_with_two_strokes()
{
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[0]) });
    scene = scene::apply_edit(std::move(scene),
                              association_of(stroke_through({ { -50, 0, 20 }, { 50, 0, 20 } })))
                .value();
    select(scene, { segments_of(scene.base->axes[1]), segments_of(scene.base->axes[2]) });
    return scene::apply_edit(std::move(scene),
                             association_of(stroke_through({ { -50, 0, 70 }, { 50, 0, 70 } })))
        .value();
}

TEST(EraseTool, TakesTheTopmostStrokeAsAWhole)
{
    auto const scene = scene_with_two_strokes();
    ASSERT_EQ(scene.associations.size(), 3u);
    auto const over = stroke_through({ { 0, -30, 100 }, { 0, -1, 100 }, { 0, 30, 100 } });
    auto const edits = edits_of(EraseTool {}, over, scene).value();
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(edits[0].get<scene::DeleteStroke>()->strokes.ids, scene::ids_of(scene, { 1, 2 }));
}

TEST(EraseTool, DoesNotReachWhatIsAboveTheSurface)
{
    auto const scene = scene_with_two_strokes();
    auto const over = stroke_through({ { 0, -1, 40 }, { 0, 1, 40 } });
    auto const edits = edits_of(EraseTool {}, over, scene).value();
    EXPECT_EQ(edits[0].get<scene::DeleteStroke>()->strokes.ids, scene::ids_of(scene, { 0 }));
    auto const below = stroke_through({ { 0, -1, 10 }, { 0, 1, 10 } });
    EXPECT_FALSE(edits_of(EraseTool {}, below, scene));
}

TEST(EraseTool, TakesAllIndicatorsThatItRunsOver)
{
    auto scene = small_scene();
    for (double const x : { -20.0, 0.0, 20.0 })
        scene = scene::apply_edit(
                    std::move(scene),
                    scene::Indicate { { .start_mm = { x, -40, 10 }, .end_mm = { x, 40, 10 } } })
                    .value();
    auto const over = stroke_through({ { -30, 0, 10 }, { -20, 0, 10 }, { -1, 0, 10 } });
    auto const edits = edits_of(EraseTool {}, over, scene).value();
    ASSERT_EQ(edits.size(), 2u);
    auto const left = scene::after(edits, scene);
    ASSERT_EQ(left.indicators.size(), 1u);
    EXPECT_EQ(left.indicators[0].id, scene.indicators[2].id);
}

TEST(Tool, HasAnOtherEnd)
{
    for (auto const* const kind : tools()) {
        auto const& [other, options] = kind->other_end;
        ASSERT_TRUE(other) << kind->word;
        if (kind == &SelectTool::kKind) {
            EXPECT_EQ(Tool(*other, options()), Tool(SelectTool { SelectionMode::Take }));
        } else if (kind == &LimbTool::kKind) {
            EXPECT_EQ(Tool(*other, options()), Tool(LimbTool { LimbTool::Does::Erase }));
        } else {
            EXPECT_EQ(other->ink.look, InkStyle::Look::Eraser) << kind->word;
        }
    }
}

Tool const kErasePart = EraseTool { EraseExtent::Part };

// Returns a stroke along x at the given height, with a tip every millimetre. Tip 0 is at x = -50
// mm.
Stroke level_stroke(double height_mm = 20)
{
    Stroke stroke;
    for (int i = 0; i <= 100; ++i)
        stroke.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                                .position_mm = { i - 50.0, 0.02 * i * i / 100, height_mm },
                                .pressure = 0.5,
                                .touching = true });
    return stroke;
}

scene::Scene scene_with(Stroke const& stroke,
                        variation::StrokeFit fit = variation::StrokeFit::Start)
{
    auto scene = small_scene();
    select(scene, { segments_of(scene.base->axes[0]) });
    return scene::apply_edit(std::move(scene), scene::Associate { .stroke = stroke, .fit = fit })
        .value();
}

// Returns the ranges of tips that a path of the eraser erases from the only stroke, in one edit.
std::vector<TipRange> erased(scene::Scene const& scene, std::vector<Vec3> const& way_mm)
{
    auto const edits = edits_of(kErasePart, stroke_through(way_mm), scene);
    if (!edits || edits->size() != 1 || !edits->front().get<scene::EraseTips>()) {
        ADD_FAILURE() << "it is not one edit that erases tips";
        return {};
    }
    EXPECT_EQ(edits->front().get<scene::EraseTips>()->strokes.ids, scene::ids_of(scene, { 0 }));
    return edits->front().get<scene::EraseTips>()->ranges;
}

TEST(ErasePartTool, TakesWhatItTouchesOfEndMiddleAndBegin)
{
    auto const scene = scene_with(level_stroke());
    auto const across = [](double x_mm) {
        return std::vector<Vec3> { { x_mm, -20, 30 }, { x_mm, 20, 30 } };
    };
    EXPECT_EQ(erased(scene, across(0.5)), (std::vector<TipRange> { { 47, 54 } }));
    EXPECT_EQ(erased(scene, across(50.5)), (std::vector<TipRange> { { 97, 100 } }));
    EXPECT_EQ(erased(scene, across(-50.5)), (std::vector<TipRange> { { 0, 3 } }));
    EXPECT_EQ(
        erased(scene,
               { { 20.5, -20, 30 }, { 20.5, 20, 30 }, { -19.5, 20, 30 }, { -19.5, -20, 30 } }),
        (std::vector<TipRange> { { 27, 34 }, { 67, 74 } }));
}

TEST(ErasePartTool, ShapesTheBranchByWhatIsLeft)
{
    auto scene = scene_with(level_stroke());
    auto const drawn
        = document::draw(stroke_through({ { 0.5, 0, 30 }, { 60, 0, 30 } }), kErasePart, scene);
    ASSERT_EQ(drawn.refusal, "");
    auto const& tips = scene.associations[0].what.stroke.tips;
    EXPECT_EQ(tips.size(), 47u);
    EXPECT_NEAR(tips.back().position_mm.x(), -4, 1e-9);
    // The next erasure acts on the part of the stroke that is still visible.
    EXPECT_EQ(erased(scene, { { -30.5, -20, 30 }, { -30.5, 20, 30 } }),
              (std::vector<TipRange> { { 16, 23 } }));
}

TEST(ErasePartTool, TakesAStrokeWholeOfWhichNothingIsLeftThatShapes)
{
    auto const scene = scene_with(level_stroke());
    // Erases the whole stroke, or all of it except a short rest.
    for (double const end_mm : { 60.0, 44.0 }) {
        auto const over = stroke_through({ { -60, 0, 30 }, { end_mm, 0, 30 } });
        auto const edits = edits_of(kErasePart, over, scene).value();
        ASSERT_EQ(edits.size(), 1u);
        EXPECT_EQ(edits[0].get<scene::DeleteStroke>()->strokes.ids, scene::ids_of(scene, { 0 }));
    }
    // The stroke is a loop with an end. Without the end it has no chord, by which it is fitted.
    Stroke loop;
    for (int i = 0; i <= 72; ++i)
        loop.tips.push_back(
            { .time = timestamp_ns(i * 5'000'000),
              .position_mm = { 40 * std::cos(i * kPi / 36), 40 * std::sin(i * kPi / 36), 20 },
              .touching = true });
    loop.tips.own().back().position_mm = loop.tips.front().position_mm;
    loop.tips.push_back({ .time = timestamp_ns(400'000'000), .position_mm = { 70, 0, 20 } });
    auto const by_chord = scene_with(loop, variation::StrokeFit::Chord);
    auto const over = stroke_through({ { 69, -10, 30 }, { 69, 10, 30 } });
    auto const edits = edits_of(kErasePart, over, by_chord).value();
    EXPECT_TRUE(edits.at(0).get<scene::DeleteStroke>());
    EXPECT_EQ(erased(scene_with(loop), { { 69, -10, 30 }, { 69, 10, 30 } }),
              (std::vector<TipRange> { { 73, 73 } }));
}

TEST(ErasePartTool, TakesTheSameOfAllBranchesOfTheTopmostStroke)
{
    auto scene = scene_with_two_strokes(); // The second stroke has a tip every 10 mm.
    auto const drawn = document::draw(stroke_through({ { -20, -30, 100 }, { -20, 30, 100 } }),
                                      kErasePart, scene);
    ASSERT_EQ(drawn.edits.size(), 1u);
    auto const& edit = *drawn.edits[0].get<scene::EraseTips>();
    EXPECT_EQ(edit.strokes.ids, scene::ids_of(scene, { 1, 2 }));
    EXPECT_EQ(edit.ranges, (std::vector<TipRange> { { 3, 3 } }));
    ASSERT_EQ(scene.associations.size(), 3u);
    EXPECT_EQ(scene.associations[0].what.stroke.tips.size(), 11u) << "it lies below";
    EXPECT_EQ(scene.associations[1].what.stroke.tips.size(), 10u);
    EXPECT_EQ(scene.associations[2].what.stroke.tips.size(), 10u);
}

TEST(ErasePartTool, DoesNotDigBelowItselfIntoAStrokeThatWasDrawnUpwards)
{
    Stroke trunk;
    for (int i = 0; i <= 100; ++i)
        trunk.tips.push_back({ .time = timestamp_ns(i * 5'000'000),
                               .position_mm = { 0.001 * i, 0, 1.5 * i },
                               .touching = true });
    auto const scene = scene_with(trunk);
    // The surface is at 90 mm. Tips above the surface are not visible, so they are not erased.
    EXPECT_EQ(erased(scene, { { -2, 0, 90 }, { 2, 0, 90 } }),
              (std::vector<TipRange> { { 55, 60 } }));
    // The surface sinks with the eraser on it, so the stroke is erased from its top.
    EXPECT_EQ(erased(scene, { { 1, 0, 160 }, { -1, 0, 100 } }),
              (std::vector<TipRange> { { 62, 100 } }));
}

TEST(ErasePartTool, TakesIndicatorsWhole)
{
    auto scene = scene_with(level_stroke());
    scene = scene::apply_edit(
                std::move(scene),
                scene::Indicate { { .start_mm = { 30, -40, 25 }, .end_mm = { 30, 40, 25 } } })
                .value();
    auto const over
        = stroke_through({ { -50, 0, 30 }, { -40, 0, 30 }, { 31, 60, 30 }, { 31, -5, 30 } });
    auto const edits = edits_of(kErasePart, over, scene).value();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(edits[0].get<scene::EraseTips>()->ranges, (std::vector<TipRange> { { 0, 15 } }))
        << "not below the indicator";
    EXPECT_EQ(edits[1].get<scene::DeleteIndicator>()->number, 0u);
    auto const beside = stroke_through({ { -50, 30, 30 }, { 0, 30, 30 } });
    EXPECT_FALSE(edits_of(kErasePart, beside, scene));
}

// Reports of the eraser may be far apart. No tips may remain between their positions.
TEST(EraseTool, MissesNothingOnItsWay)
{
    auto const scene = scene_with(level_stroke());
    Stroke fast;
    for (double const y_mm : { -40.0, 40.0 })
        fast.tips.push_back({ .position_mm = { 10.5, y_mm, 30 }, .touching = true });
    for (auto const erasing : { EraseExtent::Whole, EraseExtent::Part })
        EXPECT_TRUE(edits_of(EraseTool { erasing }, fast, scene));
}

} // namespace
} // namespace tractus::tools
