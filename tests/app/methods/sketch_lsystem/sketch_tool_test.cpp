#include "app/methods/sketch_lsystem/sketch_tool.h"

#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/methods/sketch_lsystem/sketch_previewer.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

Stroke rising_stroke()
{
    return stroke_through({ { 10, 0, 0 }, { 20, 10, 70 }, { 20, 40, 140 } });
}

TEST(SketchTool, SaysItsRuleInLogs)
{
    SketchTool tool { .laterals = 3, .angle_deg = 60, .leaves = sketch::Leaves::Bare };
    auto const words = words_for(tool);
    EXPECT_EQ(words.name + " " + words.arguments, "sketch laterals=3 angle=60 bare");
    EXPECT_EQ(parse_tool(all_methods().tools, words.name, words.arguments).value(), Tool(tool));
}

TEST(SketchTool, AddsAPlantInTheDocumentsScale)
{
    Tool const tool = SketchTool {};
    auto const alone = tool.mean(rising_stroke(), Scene {}).value();
    auto const* const first = alone.front().get<sketch::GrowAlongStroke>();
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->scale, 0.1);
    EXPECT_EQ(first->surface, StrokeSurface::Space);
    auto const scene = small_scene();
    auto const beside = tool.mean(rising_stroke(), scene).value();
    EXPECT_EQ(beside.front().get<sketch::GrowAlongStroke>()->scale, scene.placement.scale);
    auto const both = apply_edits(scene, beside).value();
    ASSERT_EQ(both.plants.size(), 2u);
    EXPECT_EQ(both.plants[0], scene.plants[0]) << "it stays as it was";
}

// The plant that grows under the pen is the one that stands there afterwards.
TEST(SketchTool, ShowsThePlantThatItWillGrow)
{
    Tool const tool = SketchTool { .leaves = sketch::Leaves::Bare };
    auto const scene = std::make_shared<Scene const>(small_scene());
    auto const stroke = rising_stroke();
    auto const lines = sketch_previewer()->show({ scene, tool, stroke.tips.vector(), 99 });
    auto const after = apply_edits(*scene, tool.mean(stroke, *scene).value()).value();
    ASSERT_EQ(lines.size(), after.base->axes.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto const nodes_mm = after.base->positions(after.base->axes[i]);
        ASSERT_EQ(lines[i].points_mm.size(), nodes_mm.size());
        for (std::size_t k = 0; k < nodes_mm.size(); ++k) {
            Vec3 const shown_mm
                = scene->placement.world_of_plant(lines[i].points_mm[k].cast<double>());
            EXPECT_NEAR((shown_mm - after.placement.world_of_plant(nodes_mm[k])).norm(), 0, 0.05);
        }
    }
    auto const too_short = stroke_through({ { 0, 0, 0 }, { 5, 0, 0 } });
    EXPECT_TRUE(sketch_previewer()->show({ scene, tool, too_short.tips.vector(), 99 }).empty());
}

// Undo, redo and a replay of what was drawn go through the document as for any other tool.
TEST(SketchTool, IsUndoneAndDoneAgain)
{
    Document document(small_scene(), Document::Working::AtOnce);
    document.draw({ rising_stroke(), SketchTool {} });
    auto const drawn = document.newest();
    ASSERT_EQ(drawn->scene.plants.size(), 2u);
    document.undo();
    EXPECT_EQ(document.newest()->scene.plants.size(), 1u);
    EXPECT_EQ(document.newest()->scene.base->segment_count(), 12u);
    document.redo();
    ASSERT_EQ(document.newest()->scene.plants.size(), 2u);
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, drawn->scene.base->node_position_mm);
}

} // namespace
} // namespace tractus
