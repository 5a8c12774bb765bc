#include "app/methods/construction_lines/layer_organs_tool.h"
#include "app/methods/construction_lines/line_layers.h"
#include "app/methods/construction_lines/line_organ_tool.h"
#include "app/methods/construction_lines/line_pattern_tool.h"
#include "engine/methods/construction_lines/line_model.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"

#include <algorithm>
#include <cmath>

// Tests of the tools that draw leaves in three views and give organs to each layer.

namespace tractus::lines {
namespace {

using namespace line_tests;
using What = LayerOrgansTool::What;
using Leaf = LineOrganTool::What;

class LayerTools : public ::testing::Test {
protected:
    LayerTools() { draw_frond(document_); }

    lines::PenSketch const& sketch()
    {
        return *lines::active_pen_sketch(document_.newest()->scene.state);
    }
    Plant const& plant() { return *document_.newest()->scene.base; }
    lines::LineModel model() { return lines::model_of(sketch()).value(); }

    // Draws a stroke and returns the message about it.
    std::string draw(std::vector<Vec3> const& places_mm, tools::Tool const& tool)
    {
        document_.take_finished_strokes();
        document_.draw({ stroke_through(places_mm), tool });
        auto const drawn = document_.take_finished_strokes().back();
        return drawn.refusal.empty() ? drawn.message : drawn.refusal;
    }
    std::string leaf(std::vector<Vec3> const& places_mm, Leaf what,
                     lines::OrganColor color = lines::OrganColor::Leaf)
    {
        return draw(places_mm, LineOrganTool { what, color });
    }
    // Draws a third inclination line. It crosses the stem at y = 0, between the others at y = -45
    // and 35 mm, and so divides the layer between them into two.
    void draw_third_line() { draw({ { -80, 20, 50 }, { -41, 0, 50 }, { 5, 20, 50 } }, spiral(3)); }
    std::string touch(double y_mm, What what)
    {
        return draw({ { -60, y_mm - 3, 50 }, { -60, y_mm, 50 } }, LayerOrgansTool { what });
    }

    document::Document document_ { scene::Scene {}, document::Document::Working::AtOnce };
};

// Returns the edge of a leaf 40 mm long: a curve that bulges by 8 mm to one side, above the middle
// of the tablet.
std::vector<Vec3> edge(double side, double from_y_mm = 0)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 20; ++i) {
        double const t = i / 20.0;
        places.emplace_back(60 + side * 32 * t * (1 - t), from_y_mm + 40 * t, 50);
    }
    return places;
}

std::vector<Vec3> reversed(std::vector<Vec3> places)
{
    std::reverse(places.begin(), places.end());
    return places;
}

std::string surface_of(lines::LineModel const& model)
{
    auto const found = model.functions.find("lines_organ_1.s");
    return found == model.functions.end() ? "" : found->second;
}

// Returns how high a leaf rises above its ends, as a share of its length of 40 mm; negative: it
// sags.
double rise_of(lines::PenSketch const& sketch)
{
    auto const surface = lines::surface_of(sketch.organs.front());
    EXPECT_TRUE(surface) << surface.error().message;
    double high = 0;
    for (auto const& patch : surface->patches)
        for (auto const& point : patch.control)
            high = std::fabs(point.z()) > std::fabs(high) ? point.z() : high;
    return high / 40;
}

TEST_F(LayerTools, AnEdgeShapesAllLeaves)
{
    auto const plain = plant();
    EXPECT_EQ(leaf(edge(1), Leaf::Edge),
              "The leaf is flat: draw its midrib, as seen from its side, to let it arch");
    ASSERT_EQ(plant().organs.size(), plain.organs.size());
    for (std::size_t i = 0; i < plain.organs.size(); ++i) {
        auto const& before = plain.organs[i];
        auto const& after = plant().organs[i];
        auto const tip = [](Plant const& of, Organ const& organ) {
            return Vec3(organ.position_mm
                        + organ.orientation
                            * Vec3(0, of.organ_shapes[organ.shape].length_mm * organ.scale.y(), 0));
        };
        EXPECT_LT((tip(plain, before) - tip(plant(), after)).norm(), 0.1) << "as long as before";
    }
    EXPECT_EQ(kOrganLayer.lines(document_.newest()->scene).size(), 1U);
    document_.undo();
    EXPECT_EQ(surface_of(model()), "");
}

// The side of an edge is recognised by its position. A missing edge is the mirror image of the
// other edge.
TEST_F(LayerTools, TheOtherEdgeIsMirroredUntilItIsDrawn)
{
    leaf(edge(1), Leaf::Edge);
    auto const mirrored = surface_of(model());
    EXPECT_NE(mirrored, "");
    leaf(edge(-1), Leaf::Edge);
    EXPECT_EQ(sketch().organs[0].lines.size(), 2U);
    EXPECT_EQ(surface_of(model()), mirrored);
    leaf(reversed(edge(-1)), Leaf::Edge);
    EXPECT_EQ(sketch().organs[0].lines.size(), 2U) << "it takes the place of the one that is there";
    EXPECT_EQ(surface_of(model()), mirrored) << "in either direction";
    leaf(edge(-2), Leaf::Edge);
    EXPECT_NE(surface_of(model()), mirrored);
}

// A line drawn upwards on the pad must bend the leaf upwards, in any direction and at any slope of
// the drawing.
TEST_F(LayerTools, MidribAndSectionBendTheLeaf)
{
    leaf(edge(1), Leaf::Edge);
    EXPECT_NEAR(rise_of(sketch()), 0, 1e-9);
    leaf({ { 0, 0, 50 }, { 10, 8, 50 }, { 20, 10, 50 }, { 30, 8, 50 }, { 40, 0, 50 } },
         Leaf::Midrib);
    EXPECT_NEAR(rise_of(sketch()), 0.25, 0.02);
    leaf({ { 40, 0, 50 }, { 30, 8, 50 }, { 20, 10, 50 }, { 10, 8, 50 }, { 0, 0, 50 } },
         Leaf::Midrib);
    EXPECT_EQ(sketch().organs[0].lines.size(), 2U);
    EXPECT_NEAR(rise_of(sketch()), 0.25, 0.02);
    leaf({ { 0, 0, 50 }, { 20, -10, 50 }, { 40, 0, 50 } }, Leaf::Midrib);
    EXPECT_NEAR(rise_of(sketch()), -0.25, 0.03);
    EXPECT_EQ(leaf({ { 40, 5, 50 }, { 30, -5, 50 }, { 20, 5, 50 } }, Leaf::Section),
              "The leaves follow the line");
    EXPECT_EQ(sketch().organs[0].lines.size(), 3U);
}

TEST_F(LayerTools, RefusesWhatGivesNoLeaf)
{
    EXPECT_EQ(leaf(edge(1), Leaf::Midrib),
              "the leaf has no side yet: draw one of its edges from base to tip");
    EXPECT_EQ(leaf({ { 0, 0, 50 }, { 0, 20, 50 }, { 0, 40, 50 } }, Leaf::Edge),
              "the leaf would have no breadth: draw its edge as a bow from base to tip");
    EXPECT_NE(leaf({ { 0, 0, 50 }, { 0, 0, 50 } }, Leaf::Edge).find("only a dot"),
              std::string::npos);
    EXPECT_TRUE(sketch().organs.empty());
    EXPECT_EQ(touch(0, What::Organ),
              "the plant has nothing but plain leaves: draw a leaf's edge, or bring an organ "
              "here");
}

// The lower layer has leaves and the upper layer has flowers.
TEST_F(LayerTools, AnotherLeafStandsInTheTopmostLayer)
{
    draw_third_line();
    auto const count = plant().organs.size();
    leaf(edge(1), Leaf::Edge);
    EXPECT_EQ(leaf(edge(2), Leaf::Another, lines::OrganColor::Violet),
              "The topmost layer bears this leaf: Layer's organ gives it to others");
    std::vector<OrganShapeId> shapes;
    for (auto const& organ : plant().organs)
        shapes.push_back(organ.shape);
    ASSERT_EQ(shapes.size(), count);
    EXPECT_NE(shapes.front(), shapes.back());
    touch(-20, What::Organ); // The lower layer gets the second leaf, too.
    for (auto const& organ : plant().organs)
        EXPECT_EQ(organ.shape, plant().organs.back().shape);
    touch(-20, What::Organ); // The touched layer gets plain leaves again.
    EXPECT_EQ(sketch().lines[3].organ, 0U);
    auto const text = model().source.text;
    EXPECT_NE(text.find("array organ[2] = {0, 2}"), std::string::npos) << text;
}

TEST_F(LayerTools, ALayerHasAPatternAndAFaceOfItsOwn)
{
    draw_third_line();
    auto const below = lines::layers_of(sketch()).value().front().nodes;
    auto const count = plant().organs.size();
    touch(-20, What::Pattern); // The pattern becomes alternate: one leaf per node, as before.
    EXPECT_EQ(plant().organs.size(), count);
    touch(-20, What::Pattern); // The touched layer gets whorls of three leaves.
    EXPECT_EQ(plant().organs.size(), count + 2 * static_cast<std::size_t>(below));
    auto const upwards = [&](std::size_t organ) {
        return (plant().organs[organ].orientation * Vec3(0, 0, 1)).z();
    };
    EXPECT_GT(upwards(0), 0.2);
    touch(-20, What::Face);
    EXPECT_LT(upwards(0), -0.2);
    EXPECT_GT(upwards(plant().organs.size() - 1), 0.2);
    // Settings for the whole plant apply to all its layers.
    document_.draw({ {}, tools::Tool(LinePatternTool {}).done_at_once() });
    EXPECT_EQ(plant().organs.size(), count) << "alternate everywhere";
    document_.draw(
        { {}, tools::Tool(LinePatternTool { LinePatternTool::What::Face }).done_at_once() });
    EXPECT_EQ(document_.take_finished_strokes().back().message,
              "The organs turn their upper side down now");
}

// A flower is drawn beside the plant and dragged to the layer whose organ it becomes.
TEST_F(LayerTools, APlantBecomesAnOrgan)
{
    auto const flower = document_.newest()->scene.state.active;
    LineTool another { .plant = LineTool::Plant::NewStem, .nodes = 4 };
    draw({ { 60, -60, 50 }, { 60, 0, 50 }, { 60, 60, 50 } }, another);
    another.plant = LineTool::Plant::GoOn;
    draw({ { 30, -62, 50 }, { 25, 0, 50 }, { 45, 68, 50 } }, another);
    auto const leaves = plant().organs.size();
    ASSERT_GT(leaves, 0U);
    auto const own = document_.newest()->scene.state.active;
    ASSERT_NE(own, flower);
    std::vector<Vec3> const from_flower { { -42, 0, 50 }, { 20, 0, 50 } };
    draw(from_flower, LayerOrgansTool { What::Plant });
    EXPECT_EQ(plant().organs.size(), leaves * 7) << "each leaf is a frond of seven now";
    EXPECT_EQ(document_.newest()->scene.state.plants.size(), 2U) << "the other one is still there";
    draw(from_flower, LayerOrgansTool { What::Plant });
    EXPECT_EQ(sketch().organs.size(), 1U) << "taken again as it is now";
    EXPECT_NE(draw({ { 60, 0, 50 }, { 55, 0, 50 } }, LayerOrgansTool { What::Plant })
                  .find("neither a leaf nor another plant"),
              std::string::npos);
    touch(0, What::Organ);
    EXPECT_EQ(plant().organs.size(), leaves) << "plain leaves again";
    document_.undo();
    EXPECT_EQ(plant().organs.size(), leaves * 7);
    EXPECT_NE(
        draw({ { 60, 0, 50 }, { 80, 30, 50 } }, LineTool { .plant = LineTool::Plant::AnotherStem })
            .find("has one stem"),
        std::string::npos);
}

// The leaf is dragged to a layer of its own plant or of another one.
TEST_F(LayerTools, ALeafIsBroughtToALayer)
{
    draw_third_line();
    leaf(edge(1), Leaf::Edge);
    leaf(edge(2, -60), Leaf::Another);
    auto const text = surface_of(model());
    draw({ { 68, 20, 50 }, { -60, 20, 50 } }, LayerOrgansTool { What::Plant });
    EXPECT_EQ(sketch().organs.size(), 2U);
    EXPECT_NE(model().source.text.find("array organ[2] = {1, 1}"), std::string::npos);

    LineTool const another { .plant = LineTool::Plant::NewStem, .nodes = 4 };
    draw({ { 120, -60, 50 }, { 120, 0, 50 }, { 120, 60, 50 } }, another);
    draw({ { 95, -62, 50 }, { 90, 0, 50 }, { 105, 68, 50 } }, LineTool { .nodes = 4 });
    EXPECT_TRUE(sketch().organs.empty());
    draw({ { 68, 20, 50 }, { 130, 20, 50 } }, LayerOrgansTool { What::Plant });
    ASSERT_EQ(sketch().organs.size(), 1U);
    EXPECT_FALSE(sketch().organs[0].sketch);
    EXPECT_EQ(surface_of(model()), text) << "as it is there";
}

TEST(LayerToolsInLogs, SayTheirOptions)
{
    EXPECT_EQ(line_of(LayerOrgansTool {}), "layer_organs ");
    EXPECT_EQ(line_of(LayerOrgansTool { What::Pattern }), "layer_organs layer_pattern");
    EXPECT_EQ(line_of(LayerOrgansTool { What::Plant }), "layer_organs layer_plant");
    EXPECT_EQ(line_of(LineOrganTool { Leaf::Section, lines::OrganColor::Pink }),
              "line_organ section pink");
}

} // namespace
} // namespace tractus::lines
