#include "app/methods/all_methods.h"
#include "app/methods/sketch_lsystem/sketch_tool.h"
#include "app/tools/tool_choices.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/scene/scene.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

// Tests of strokes drawn from the tip of a plant to its foot, and of laterals that give way to
// others.

namespace tractus::sketch {
namespace {

Stroke upward_stroke()
{
    return stroke_through({ { 10, 0, 0 }, { 20, 10, 70 }, { 20, 40, 140 } });
}

// Returns a stroke on paper from the tip of a tree down to its foot, slightly to the right.
Stroke falling_stroke()
{
    return stroke_through({ { -5, 150, 100 }, { 0, 80, 100 }, { 5, 0, 100 } });
}

TEST(SketchTool, TurnsAStrokeRoundThatWasDrawnFromTheTip)
{
    tools::Tool const tool = SketchTool { .surface = StrokeSurface::Paper };
    auto const edits = tool.edits_for(falling_stroke(), {}).value();
    auto const grown = *edits.front().get<sketch::GrowAlongStroke>();
    EXPECT_TRUE(grown.is_drawn_reversed);
    auto const scene = scene::apply_edits(scene::Scene {}, edits).value();
    EXPECT_NEAR(sketch::stands_at_mm(grown).x(), 5, 1e-9);
    double lowest_mm = 0;
    for (auto const& node_mm : scene.base->node_position_mm)
        lowest_mm = std::min(lowest_mm, node_mm.z());
    // In plant millimetres. An inverted plant would reach 1500 mm below the desk.
    EXPECT_GT(lowest_mm, -100);
    EXPECT_NE(SketchTool::kKind.describe(tool, scene).find("turned round"), std::string::npos)
        << SketchTool::kKind.describe(tool, scene);

    // With TurnRound, the tool reverses the plant's stroke; used again, it restores the first
    // plant.
    tools::Tool const turn = SketchTool { .place = SketchTool::Place::TurnRound };
    auto const back = scene::apply_edits(scene, turn.edits_for({}, scene).value()).value();
    auto const newest = *sketch::newest_grown(*back.drawn)->sketch;
    EXPECT_FALSE(newest.is_drawn_reversed);
    EXPECT_NEAR(newest.stroke.tips.vector().front().position_mm.y(), 150, 1e-9);
    EXPECT_NEAR(back.state.plants[0]->stands_at_mm.x(), -5, 1e-9);
    auto const again = scene::apply_edits(back, turn.edits_for({}, back).value()).value();
    EXPECT_EQ(again.base->node_position_mm, scene.base->node_position_mm);
}

TEST(SketchTool, LeavesStrokesOfOlderLogsAndRisingOnesAsDrawn)
{
    auto const tools = methods::all_methods().tools;
    auto const older = tools::parse_tool(tools, "sketch", "paper").value();
    auto const drawn = older.edits_for(falling_stroke(), {}).value();
    EXPECT_FALSE(drawn.front().get<sketch::GrowAlongStroke>()->is_drawn_reversed);
    auto const rising = tools::Tool(SketchTool {}).edits_for(upward_stroke(), {}).value();
    EXPECT_FALSE(rising.front().get<sketch::GrowAlongStroke>()->is_drawn_reversed);
    EXPECT_EQ(SketchTool::kKind.describe(tools::Tool(SketchTool {}),
                                         scene::apply_edits(scene::Scene {}, rising).value()),
              "");
}

TEST(SketchTool, GivesWayWithinTheMillimetresOfItsOption)
{
    auto const tools = methods::all_methods().tools;
    auto const tool = tools::parse_tool(tools, "sketch", "room=4").value();
    auto const edits = tool.edits_for(upward_stroke(), {}).value();
    EXPECT_EQ(edits.front().get<sketch::GrowAlongStroke>()->rule.occupancy_radius_mm, 4);
    EXPECT_FALSE(tools::parse_tool(tools, "sketch", "room=400"));
}

} // namespace
} // namespace tractus::sketch
