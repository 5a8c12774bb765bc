#include "app/methods/silhouettes/crown_tool.h"

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/erase_crown_tool.h"
#include "app/methods/silhouettes/outline_layer.h"
#include "app/session/edit_record.h"
#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/drawn_surface.h"
#include "engine/scene/paper.h"
#include "tests/app/methods/silhouettes/drawn_trees.h"
#include "tests/app/replayed.h"
#include "tests/app/simulated_drawing.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tractus::silhouette {
namespace {

using namespace drawn_trees;
using silhouette::EraseTreePart;

// Returns a ring of the given width and depth around a position in space.
Stroke ring_at(Vec3 const& middle_mm, double wide_mm, double deep_mm)
{
    std::vector<Vec3> places;
    for (int i = 0; i < 90; ++i) {
        double const angle = i * 2 * kPi / 90;
        places.emplace_back(middle_mm
                            + Vec3(wide_mm * std::cos(angle), deep_mm * std::sin(angle), 0));
    }
    return stroke_through(places);
}

// Returns a line that climbs around a cone on the vertical axis of the world, from a height of 40
// mm to 140 mm.
Stroke climb_on_cone()
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 500; ++i) {
        double const share = i / 500.0;
        double const angle = 10 * kPi * share;
        double const r = 40 * (1 - 0.95 * share);
        places.emplace_back(r * std::cos(angle), r * std::sin(angle), 40 + 100 * share);
    }
    return stroke_through(places);
}

Result<std::vector<scene::Edit>> meant_by(Stroke const& stroke, scene::Scene const& scene,
                                          tools::Tool const& tool = CrownTool {})
{
    return tool.edits_for(stroke, scene);
}

scene::Scene drawn_after(scene::Scene const& scene, Stroke const& stroke,
                         tools::Tool const& tool = CrownTool {})
{
    auto const edits = meant_by(stroke, scene, tool);
    EXPECT_TRUE(edits) << edits.error().message;
    auto after = edits ? scene::apply_edits(scene, *edits) : Result<scene::Scene>(scene);
    EXPECT_TRUE(after) << after.error().message;
    return after.value_or(scene::Scene {});
}

silhouette::OutlinedTree const& tree_of(scene::Scene const& scene)
{
    return *silhouette::outlined_tree(*scene.drawn);
}

// Returns the maximum extent of the plant along an axis of the world frame.
double reach(scene::Scene const& scene, int axis)
{
    auto const box = bounds(*scene.base);
    return scene.placement.scale * (box.max_mm[axis] - box.min_mm[axis]);
}

TEST(CrownTool, SaysItsWordsInLogs)
{
    EXPECT_EQ(tools::words_for(CrownTool {}).arguments, "whole_nodes fills_by_spacing");
    CrownTool const of_old_logs { .nodes = NodesOption::AsAtFirst,
                                  .fills = FillsOption::AsAtFirst };
    EXPECT_EQ(tools::words_for(of_old_logs).arguments, "");
    auto const words = tools::words_for(CrownTool { CrownTool::What::New });
    EXPECT_EQ(words.name + " " + words.arguments, "crown_line new whole_nodes fills_by_spacing");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(CrownTool { CrownTool::What::New }));
}

// Rings alone must make a tree. It stands on the desk below the rings, with their width and depth.
TEST(CrownTool, RingsMakeATreeUnderThem)
{
    scene::Scene scene;
    for (double const height : { 60.0, 90.0, 120.0 })
        scene = drawn_after(scene, ring_at({ 20, 15, height }, 45, 18));
    ASSERT_EQ(scene.plants.size(), 1U);
    EXPECT_NEAR(scene.drawn->stands_at_mm.x(), 20, 0.5);
    EXPECT_NEAR(scene.drawn->stands_at_mm.y(), 15, 0.5);
    EXPECT_EQ(scene.drawn->stands_at_mm.z(), 0);
    EXPECT_EQ(tree_of(scene).crown_lines.size(), 3U);
    EXPECT_GT(reach(scene, 0), 1.5 * reach(scene, 1));
    EXPECT_NEAR(reach(scene, 0), 90, 18);
    EXPECT_NEAR(scene.placement.scale * bounds(*scene.base).max_mm.z(), 130, 15);
    EXPECT_EQ(
        CrownTool::kKind.describe(CrownTool {}, scene).rfind("The crown goes through 3 rings", 0),
        0U)
        << CrownTool::kKind.describe(CrownTool {}, scene);
}

TEST(CrownTool, AClimbingLineIsACrownAndAnotherTakesItsPlace)
{
    auto scene = drawn_after({}, climb_on_cone());
    EXPECT_EQ(tree_of(scene).crown_lines.size(), 1U);
    EXPECT_NEAR(scene.placement.scale * bounds(*scene.base).max_mm.z(), 142, 12);
    auto const drawing = silhouette::drawing_of(tree_of(scene)).value();
    silhouette::CrownSurface const surface(drawing.surface, drawing.trunk);
    EXPECT_NEAR(surface.reach(77, 90).value_or(0), 40 * (1 - 0.95 * 0.5), 0.5);
    scene = drawn_after(scene, climb_on_cone());
    EXPECT_EQ(tree_of(scene).crown_lines.size(), 1U);
}

// Rings around a tree that was drawn on the sheet define its crown, while its outline stays.
TEST(CrownTool, RingsAroundATreeSayHowDeepItIs)
{
    auto const flat = crowned();
    auto const paper = scene::paper_of(flat.state);
    double const middle = paper.world_of_sheet({ 0, 10 }).z();
    auto deep = flat;
    for (double const up : { -20.0, 0.0, 20.0 })
        deep = drawn_after(deep, ring_at({ 0, 0, middle + up }, 36, 14));
    ASSERT_EQ(deep.plants.size(), 1U);
    EXPECT_EQ(deep.drawn->stands_at_mm, flat.drawn->stands_at_mm);
    EXPECT_LT(reach(deep, 1), 0.75 * reach(flat, 1));
    EXPECT_NEAR(reach(deep, 0), reach(flat, 0), 0.2 * reach(flat, 0));
    EXPECT_EQ(deep.plants[0]->drawn->id, flat.plants[0]->drawn->id);
    auto const beside = drawn_after(deep, ring_at({ 90, 0, middle }, 20, 20));
    EXPECT_EQ(beside.plants.size(), 2U);
    auto const other
        = drawn_after(deep, ring_at({ 0, 0, middle }, 20, 20), CrownTool { CrownTool::What::New });
    EXPECT_EQ(other.plants.size(), 2U);
}

TEST(CrownTool, RefusesALineThatSaysNothing)
{
    auto const refused = meant_by(
        stroke_through({ { 0, 0, 10 }, { 20, 5, 30 }, { 40, 20, 60 }, { 50, 40, 90 } }), {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("draw a ring around the trunk"), std::string::npos);
    EXPECT_FALSE(meant_by(ring_at({ 0, 0, 50 }, 20, 20), {}, EraseCrownTool {}));
}

TEST(CrownTool, ErasesWhatTheEraserComesNear)
{
    scene::Scene scene;
    for (double const height : { 60.0, 90.0, 120.0 })
        scene = drawn_after(scene, ring_at({ 0, 0, height }, 40, 30));
    tools::Tool const eraser = EraseCrownTool {};
    auto const after = drawn_after(scene, stroke_through({ { 36, 0, 91 }, { 44, 2, 93 } }), eraser);
    ASSERT_EQ(tree_of(after).crown_lines.size(), 2U);
    EXPECT_FALSE(meant_by(stroke_through({ { 0, 0, 75 }, { 1, 2, 75 } }), after, eraser));
    // The last line cannot be erased, since nothing of the tree would be left.
    auto one = drawn_after(after, stroke_through({ { 40, 0, 60 }, { 41, 0, 60 } }), eraser);
    auto const edits = meant_by(stroke_through({ { 40, 0, 120 }, { 41, 0, 120 } }), one, eraser);
    ASSERT_TRUE(edits);
    EXPECT_FALSE(scene::apply_edits(one, *edits));
}

// The lines of the crown must be shown where they were drawn in space.
TEST(CrownTool, ShowsItsLinesInSpace)
{
    auto const scene = drawn_after({}, ring_at({ 20, 15, 60 }, 45, 18));
    auto const lines = kOutlineLayer.lines(*scene.plants[0]);
    ASSERT_EQ(lines.size(), 1U);
    for (auto const& point : lines[0]) {
        EXPECT_NEAR(point.z(), 60, 0.1);
        EXPECT_NEAR(std::hypot((point.x() - 20) / 45, (point.y() - 15) / 18), 1, 0.01);
    }
}

TEST(CrownTool, PreviewsTheTreeThatComesOut)
{
    auto const stroke = ring_at({ 0, 0, 60 }, 45, 18);
    auto const previewer = crown_previewer();
    tools::Tool const tool = CrownTool {};
    std::vector<TipSample> const ink(stroke.tips.begin(), stroke.tips.end());
    auto const shown = previewer->show({ std::make_shared<scene::Scene const>(), tool, ink });
    auto const scene = drawn_after({}, stroke);
    auto const on_trunk = std::count_if(scene.base->axes.begin(), scene.base->axes.end(),
                                        [](Axis const& axis) { return axis.order <= 1; });
    EXPECT_EQ(shown.size(), static_cast<std::size_t>(on_trunk));
    EXPECT_TRUE(
        previewer->show({ std::make_shared<scene::Scene const>(), tool, std::span(ink).first(20) })
            .empty());
}

// The lines must give the same tree when they are recorded, replayed or drawn directly, and a
// session must keep the tree.
TEST(CrownTool, ReplaysToTheSameTree)
{
    std::string hand = "version = 1\nseed = 8\n";
    for (double const height : { 60.0, 90.0, 110.0 }) {
        std::string points;
        for (int i = 0; i <= 60; ++i)
            points += fmt::format("{}[{:.3f}, {:.3f}, {}]", i > 0 ? ", " : "",
                                  40 * std::cos(i * kPi / 30), 20 * std::sin(i * kPi / 30), height);
        hand += fmt::format("[[gesture]]\ntool = \"draw\"\npropagation = \"both\"\npath = "
                            "\"polyline\"\npoints_mm = [{}]\n",
                            points);
    }
    auto log = recorded_log(hand);
    for (auto& tool : log.tools) {
        tool.tool = "crown_line";
        tool.arguments = "whole_nodes fills_by_spacing";
    }
    auto const replay = replayed(log, {}, scene::Scene {});
    ASSERT_EQ(replay.strokes.size(), 3U);
    scene::Scene alone;
    for (auto const& drawn : replay.strokes) {
        EXPECT_EQ(drawn.refusal, "");
        alone = drawn_after(alone, drawn.stroke);
    }
    ASSERT_EQ(tree_of(replay.scene).crown_lines.size(), 3U);
    EXPECT_EQ(alone.base->node_position_mm, replay.scene.base->node_position_mm);
    // The edit must be the same after it is written to a session's record and read again.
    auto const edits = meant_by(replay.strokes[0].stroke, {}).value();
    auto const again = session::edit_of(session::record_of(edits[0]), methods::all_methods().edits);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(scene::apply_edit(scene::Scene {}, *again).value().base->node_position_mm,
              scene::apply_edit(scene::Scene {}, edits[0]).value().base->node_position_mm);
}

} // namespace
} // namespace tractus::silhouette
