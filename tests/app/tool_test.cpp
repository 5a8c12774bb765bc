#include "app/tools/tool.h"

#include "engine/plant/join_axes.h"
#include "tests/app/small_model.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(Tool, IsReadAndWrittenAsWords)
{
    for (auto const& tool :
         { Tool { Tool::Kind::Select }, Tool { Tool::Kind::Indicate },
           Tool { Tool::Kind::DrawInOrder }, Tool { Tool::Kind::Draw, Propagation::Selected },
           Tool { Tool::Kind::Draw, Propagation::Descendants },
           Tool { Tool::Kind::Draw, Propagation::Both } }) {
        auto const words = words_for(tool);
        EXPECT_EQ(parse_tool(words.name, words.arguments).value(), tool) << words.name;
    }
}

TEST(Tool, NamesTheToolsThereAre)
{
    EXPECT_NE(parse_tool("hammer", "").error().message.find("select, draw, indicate"),
              std::string::npos);
    EXPECT_NE(
        parse_tool("draw", "everything").error().message.find("selected, descendants or both"),
        std::string::npos);
}

// Where the selection view shows a node, as a pen would have to point there.
Vec3 shown(Scene const& scene, Vec3 const& plant_mm)
{
    auto const view = fit_selection_view(*scene.base);
    auto const place = view.tablet_of_plant(plant_mm);
    return { place.x(), place.y(), 40 };
}

TEST(SelectTool, SelectsTheAxisThatThePenFollows)
{
    auto const scene = small_scene();
    auto const nodes = scene.base->positions(scene.base->axes[0]);
    auto const stroke = stroke_through({ shown(scene, nodes.front() + Vec3(0, 0, 20)),
                                         shown(scene, nodes.back() - Vec3(0, 0, 20)) });
    auto const edits = edits_of({ Tool::Kind::Select }, stroke, scene);
    ASSERT_TRUE(edits) << edits.error().message;
    ASSERT_EQ(edits->size(), 1u);
    EXPECT_EQ(std::get<Select>((*edits)[0]).paths, Selection { segments_of(scene.base->axes[0]) });
}

TEST(SelectTool, SaysThatAStrokeWentBesideThePlant)
{
    auto const scene = small_scene();
    auto const stroke = stroke_through({ { -120, 70, 0 }, { -120, 40, 0 } });
    auto const edits = edits_of({ Tool::Kind::Select }, stroke, scene);
    ASSERT_FALSE(edits);
    EXPECT_EQ(edits.error().fault, Fault::User);
}

TEST(DrawTool, ShapesWhatIsSelected)
{
    auto scene = small_scene();
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } });
    EXPECT_FALSE(edits_of({ Tool::Kind::Draw }, stroke, scene));
    scene.selection = { segments_of(scene.base->axes[1]) };
    auto const edits = edits_of({ Tool::Kind::Draw, Propagation::Both }, stroke, scene);
    ASSERT_TRUE(edits);
    EXPECT_EQ(std::get<Associate>((*edits)[0]).propagation, Propagation::Both);
}

TEST(IndicateTool, TakesTheEndsOfTheStroke)
{
    auto const stroke = stroke_through({ { 0, 0, 100 }, { 30, 50, 100 }, { 80, 0, 120 } });
    auto const edits = edits_of({ Tool::Kind::Indicate }, stroke, small_scene()).value();
    EXPECT_EQ(std::get<Indicate>(edits[0]).indicator.start_mm, Vec3(0, 0, 100));
    EXPECT_EQ(std::get<Indicate>(edits[0]).indicator.end_mm, Vec3(80, 0, 120));
}

TEST(DrawInOrderTool, ShapesTheTrunkFirstAndThenTheLongestBranch)
{
    auto scene = small_scene();
    auto const stroke = stroke_through({ { 0, 0, 0 }, { 0, 0, 100 } });
    std::vector<AxisId> drawn;
    for (int turn = 0; turn < 4; ++turn) {
        auto const edits = edits_of({ Tool::Kind::DrawInOrder }, stroke, scene).value();
        for (auto const& edit : edits)
            scene = apply_edit(scene, edit).value();
        drawn.push_back(axis_of(*scene.base, std::get<Select>(edits[0]).paths[0][0]));
    }
    auto const order = axes_in_drawing_order(*scene.base);
    EXPECT_EQ(drawn, (std::vector<AxisId> { order[0], order[1], order[2], order[0] }));
    EXPECT_EQ(scene.base->axes[order[1]].segment_count, 4u);
}

} // namespace
} // namespace tractus
