#include "app/methods/construction_lines/layer_nodes_tool.h"
#include "app/methods/construction_lines/line_layers.h"
#include "app/methods/construction_lines/line_pattern_tool.h"
#include "app/methods/construction_lines/line_role_tool.h"
#include "engine/methods/construction_lines/line_model.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"
#include "tests/app/small_model.h"

#include <fmt/format.h>

// Tests of tools that change a construction-line sketch by touching it, and of the display of its
// lines.

namespace tractus::lines {
namespace {

using namespace line_tests;
using lines::Pattern;
using lines::Role;

// The layers must show the lines of a sketch where its plant is, even if the plant was moved or
// scaled.
TEST(LineLayers, ShowTheLinesByWhatTheyAre)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    document.draw({ stroke_through({ { 80, 0, 50 }, { 90, 10, 50 } }), spiral() });
    auto const& drawn = document.newest()->scene;
    EXPECT_EQ(kBoundaryLayer.lines(drawn).size(), 2U);
    EXPECT_EQ(kInclinationLayer.lines(drawn).size(), 2U);
    EXPECT_EQ(kUnsureLayer.lines(drawn).size(), 1U);
    EXPECT_TRUE(kLinesToDrawLayer.lines(drawn).empty());
    EXPECT_TRUE(kStemLayer.lines(small_scene()).empty());
    EXPECT_TRUE(kLinesToDrawLayer.lines(small_scene()).empty());
    std::vector<scene::Edit> const changes { scene::MovePlant { drawn.state.active, { 25, 10, 0 } },
                                             scene::SetScale { 0.04 } };
    for (auto const& scene : { drawn, scene::apply_edits(drawn, changes).value() }) {
        auto const stems = kStemLayer.lines(scene);
        ASSERT_EQ(stems.size(), 1U);
        auto const at_mm = [&](Vec3f const& point_mm) { return Vec3(point_mm.cast<double>()); };
        EXPECT_NEAR((at_mm(stems[0].front()) - scene.placement.origin_mm).norm(), 0, 0.01);
        auto const& axis = scene.base->axes.at(0);
        Vec3 const top_mm = scene.placement.world_of_plant(scene.base->positions(axis).back());
        EXPECT_NEAR((at_mm(stems[0].back()) - top_mm).norm(), 0, 0.5);
    }
}

TEST(LinePatternTool, GoesThroughThePatterns)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    std::string patterns;
    for (int i = 0; i < 5; ++i) {
        document.draw({ {}, tools::Tool(LinePatternTool {}).done_at_once() });
        patterns += fmt::format("{} ", document.newest()->scene.base->organs.size());
    }
    // The stem has seven nodes. The patterns are alternate with 7 organs, whorls of three with 21,
    // two patterns with two organs per node, and spiral again.
    EXPECT_EQ(patterns, "7 21 14 14 7 ");
    EXPECT_EQ(document.take_finished_strokes().back().message, "The organs are spiral now");
    scene::Scene scene = small_scene();
    EXPECT_NE(
        document::draw({}, LinePatternTool {}, scene).refusal.find("has no construction lines"),
        std::string::npos);
}

TEST(LinePatternTool, LetsSizesFollowHalfEllipsesAndBack)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    auto const model = [&] {
        return lines::model_of(*lines::active_pen_sketch(document.newest()->scene.state)).value();
    };
    auto const linear = model();
    tools::Tool const sizes(LinePatternTool { LinePatternTool::What::Sizes });
    EXPECT_EQ(line_of(sizes.done_at_once()), "line_pattern sizes now");
    document.draw({ {}, sizes.done_at_once() });
    EXPECT_EQ(model().functions.size(), linear.functions.size() + 2);
    EXPECT_EQ(document.take_finished_strokes().back().message,
              "Sizes follow half-ellipses around the stem now");
    document.draw({ {}, tools::Tool(LinePatternTool {}).done_at_once() });
    EXPECT_NE(model().source.text.find("azimuth[0]"), std::string::npos) << "in any pattern";
    document.undo();
    document.draw({ {}, sizes.done_at_once() });
    EXPECT_EQ(model().source.text, linear.source.text);
}

// A layer proposes where to draw a missing boundary. Drawing the boundary there must be accepted as
// such.
TEST(LineLayers, ShowWhereALineIsMissing)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    for (std::size_t i : { 0U, 1U, 3U, 4U }) // The right boundary is left out.
        document.draw({ frond()[i], spiral() });
    auto const scene = document.newest()->scene;
    auto const missing = kLinesToDrawLayer.lines(scene);
    ASSERT_EQ(missing.size(), 1U);
    std::vector<Vec3> points;
    for (auto const& point : missing[0])
        // Converts from the upright sheet to the tablet, in mm.
        points.emplace_back(point.x(), point.z() - 100, 50);
    document.draw({ stroke_through(points), spiral() });
    auto const drawn = document.take_finished_strokes();
    EXPECT_EQ(drawn.back().message, "This is the right boundary");
    EXPECT_TRUE(kLinesToDrawLayer.lines(document.newest()->scene).empty());
}

TEST(LayerNodesTool, ChangesTheLayerThatIsTouchedOrTheTopmost)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    auto const organs = [&] { return document.newest()->scene.base->organs.size(); };
    document.draw(
        { stroke_through({ { -90, -60, 50 }, { -45, 0, 50 } }), LayerNodesTool { .nodes = 20 } });
    EXPECT_EQ(organs(), 21U);
    document.draw(
        { {}, tools::Tool(LayerNodesTool { LayerNodesTool::What::More }).done_at_once() });
    EXPECT_EQ(organs(), 22U);
    for (int i = 0; i < 2; ++i)
        document.draw(
            { {}, tools::Tool(LayerNodesTool { LayerNodesTool::What::Fewer }).done_at_once() });
    EXPECT_EQ(organs(), 20U);
    document.draw({ frond()[0], LayerNodesTool { .nodes = 0 } });
    EXPECT_EQ(organs(), 1U);
    document.take_finished_strokes();
    document.draw(
        { {}, tools::Tool(LayerNodesTool { LayerNodesTool::What::Fewer }).done_at_once() });
    EXPECT_EQ(document.take_finished_strokes().back().refusal,
              "the topmost layer has 0 nodes, and cannot have fewer");
}

TEST(LineRoleTool, SaysWhatTheTouchedLineIs)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    auto const touch = [](double x, double y) {
        return stroke_through({ { x - 3, y, 50 }, { x, y, 50 } });
    };
    document.draw({ touch(-12, 0), LineRoleTool { Role::Unsure } });
    auto const* sketch = lines::active_pen_sketch(document.newest()->scene.state);
    EXPECT_EQ(sketch->lines[2].role, Role::Unsure);
    document.draw({ touch(-12, 0), LineRoleTool { Role::Right } });
    sketch = lines::active_pen_sketch(document.newest()->scene.state);
    EXPECT_EQ(sketch->lines[2].role, Role::Right);
    document.take_finished_strokes();
    document.draw({ touch(100, 0), LineRoleTool { Role::Right } });
    document.draw({ touch(-42, 0), LineRoleTool { Role::Left } });
    auto const drawn = document.take_finished_strokes();
    EXPECT_NE(drawn[0].refusal.find("no construction line here"), std::string::npos);
    EXPECT_NE(drawn[1].refusal.find("would have no stem"), std::string::npos);
}

} // namespace
} // namespace tractus::lines
