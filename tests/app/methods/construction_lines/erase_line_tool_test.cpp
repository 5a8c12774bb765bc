#include "app/methods/construction_lines/erase_line_tool.h"

#include "app/methods/construction_lines/line_organ_tool.h"
#include "app/methods/construction_lines/line_previewer.h"
#include "engine/methods/construction_lines/line_model.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"

#include <memory>

namespace tractus::lines {
namespace {

using namespace line_tests;
using Leaf = LineOrganTool::What;

class EraseLines : public ::testing::Test {
protected:
    void draw(std::vector<Vec3> const& places_mm, tools::Tool const& tool)
    {
        document_.draw({ stroke_through(places_mm), tool });
        said_ = document_.take_finished_strokes().back();
    }
    void erase(std::vector<Vec3> const& places_mm) { draw(places_mm, EraseLineTool {}); }

    PenSketch const& sketch() { return *active_pen_sketch(document_.newest()->scene.state); }
    std::map<std::string, std::string> model()
    {
        auto model = model_of(sketch()).value();
        model.functions["the text"] = model.source.text + model.source.view_text;
        return model.functions;
    }

    document::Document document_ { scene::Scene {}, document::Document::Working::AtOnce };
    document::DrawnStroke said_ {};
};

// After a line of any kind is erased, the plant must be as it was before the line.
TEST_F(EraseLines, TakesBackWhatALineDid)
{
    struct Line {
        char const* what;
        std::vector<Vec3> places_mm;
        tools::Tool tool;
    };
    tools::Tool const another_stem = LineTool { .plant = LineTool::Plant::AnotherStem, .nodes = 4 };
    tools::Tool const edge = LineOrganTool { Leaf::Edge };
    std::vector<Line> const lines {
        { "a third inclination line",
          { { -80, 20, 50 }, { -41, 0, 50 }, { 5, 20, 50 } },
          spiral() },
        { "a line of which nobody knows", { { 80, 0, 50 }, { 90, 10, 50 } }, spiral() },
        { "another stem", { { 120, -60, 50 }, { 120, 60, 50 } }, another_stem },
        { "a leaf's edge", { { 60, 0, 50 }, { 70, 20, 50 }, { 60, 40, 50 } }, edge },
    };
    draw_frond(document_);
    for (auto const& line : lines) {
        auto const before = model();
        draw(line.places_mm, line.tool);
        ASSERT_EQ(said_.refusal, "") << line.what;
        Vec3 const middle_mm = line.places_mm[line.places_mm.size() - 2];
        Vec3 const beside_mm = 0.7 * middle_mm + 0.3 * line.places_mm.back();
        erase({ beside_mm, beside_mm + Vec3(1, 0, 0) });
        EXPECT_EQ(said_.refusal, "") << line.what;
        EXPECT_EQ(model(), before) << line.what;
        document_.undo();
        document_.undo();
    }
}

TEST_F(EraseLines, ABoundaryCanBeDrawnAgain)
{
    draw_frond(document_);
    auto const whole = model();
    erase({ { -80, 0, 50 }, { -70, 0, 50 } });
    EXPECT_EQ(said_.refusal, "");
    EXPECT_EQ(sketch().lines.size(), 4U);
    EXPECT_NE(model(), whole);
    draw({ { -70, -62, 50 }, { -75, 0, 50 }, { -55, 68, 50 } }, spiral());
    EXPECT_EQ(model(), whole);
}

// An eraser that follows an inclination line also crosses the stem, which must not be erased.
TEST_F(EraseLines, TheStemStaysWhereSomethingElseIsTouched)
{
    draw_frond(document_);
    erase({ { -90, -30, 50 }, { -41, -45, 50 }, { -20, -32, 50 } });
    EXPECT_EQ(said_.refusal, "");
    EXPECT_EQ(sketch().lines.size(), 3U) << "the line, and the boundary that it ran over";
    EXPECT_EQ(sketch().lines[0].role, Role::Stem);
    erase({ { -42, 0, 50 }, { -41, 3, 50 } });
    EXPECT_NE(said_.refusal.find("would have no stem"), std::string::npos) << said_.refusal;
    erase({ { 100, 0, 50 }, { 110, 3, 50 } });
    EXPECT_NE(said_.refusal.find("touched no construction line"), std::string::npos);
    EXPECT_EQ(sketch().lines.size(), 3U);
}

// Erasing a stem also removes the lines on it; other stems keep their lines.
TEST_F(EraseLines, AStemGoesWithWhatStandsOnIt)
{
    draw_frond(document_);
    LineTool another { .plant = LineTool::Plant::AnotherStem, .nodes = 4 };
    // The second stroke is a lateral axis on the first stem.
    draw({ { -42, 0, 50 }, { 20, 40, 50 }, { 60, 50, 50 } }, another);
    draw({ { 120, -60, 50 }, { 120, 60, 50 } }, another);
    another.plant = LineTool::Plant::GoOn;
    draw({ { 95, -62, 50 }, { 90, 0, 50 }, { 105, 68, 50 } }, another);
    auto const lines = sketch().lines;
    ASSERT_EQ(lines.size(), 8U);
    ASSERT_EQ(lines[5].parent, std::optional<std::size_t>(0));
    erase({ { -41, -20, 50 }, { -41, -22, 50 } });
    ASSERT_EQ(said_.refusal, "");
    ASSERT_EQ(sketch().lines.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(sketch().lines[i].id, lines[6 + i].id);
        EXPECT_EQ(sketch().lines[i].stem, 0U);
    }
    EXPECT_GT(document_.newest()->scene.base->organs.size(), 0U);
    document_.undo();
    EXPECT_EQ(sketch().lines.size(), 8U);
}

// A leaf exists as long as one of its sides is left.
TEST_F(EraseLines, ALeafGoesWithItsLastSide)
{
    draw_frond(document_);
    auto const plain = model();
    draw({ { 60, 0, 50 }, { 70, 20, 50 }, { 60, 40, 50 } }, LineOrganTool { Leaf::Edge });
    auto const flat = model();
    draw({ { 20, 90, 50 }, { 40, 98, 50 }, { 60, 90, 50 } }, LineOrganTool { Leaf::Midrib });
    EXPECT_NE(model(), flat);
    erase({ { 40, 90, 50 }, { 40, 99, 50 } });
    EXPECT_EQ(model(), flat);
    document_.undo();
    erase({ { 60, 20, 50 }, { 70, 20, 50 } });
    EXPECT_EQ(said_.refusal, "");
    EXPECT_TRUE(sketch().organs.empty()) << "a midrib alone is no leaf";
    EXPECT_EQ(model(), plain);
}

TEST_F(EraseLines, TheOtherEndOfThePenDoesSo)
{
    std::vector<tools::ToolKind const*> kinds;
    for (auto const* const kind : methods::all_methods().tools)
        if (std::string_view(kind->method) == "From lines")
            kinds.push_back(kind);
    EXPECT_GE(kinds.size(), 7U);
    for (auto const* const kind : kinds)
        EXPECT_EQ(kind->other_end.kind, &EraseLineTool::kKind) << kind->word;
    EXPECT_EQ(line_of(EraseLineTool {}), "erase_line ");
}

// While an edge of a leaf is being drawn, all leaves of the plant must show both of their edges and
// their midrib.
TEST_F(EraseLines, TheLineUnderWayOfALeafIsShownOnThePlant)
{
    draw_frond(document_);
    auto const& scene = document_.newest()->scene;
    auto const shown = [&](std::vector<Vec3> const& places_mm, tools::Tool const& tool) {
        return line_previewer()->show({ std::make_shared<scene::Scene const>(scene), tool,
                                        stroke_through(places_mm).tips.vector(), 99 });
    };
    auto const organs = scene.base->organs.size();
    auto const axes = scene.base->axes.size();
    auto const leaf
        = shown({ { 60, 0, 50 }, { 70, 20, 50 }, { 60, 40, 50 } }, LineOrganTool { Leaf::Edge });
    ASSERT_EQ(leaf.size(), axes + 3 * organs);
    // Each side curves away from the midrib by up to a quarter of the midrib's length.
    auto const& left = leaf[axes].points_mm;
    auto const& midrib = leaf[axes + 1].points_mm;
    auto const& right = leaf[axes + 2].points_mm;
    float const length_mm = (midrib.back() - midrib.front()).norm();
    float widest_mm = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
        widest_mm = std::max(widest_mm, (left[i] - right[i]).norm());
    EXPECT_NEAR(widest_mm / length_mm, 20.0 / 40, 0.06);
    EXPECT_TRUE(
        shown({ { 60, 0, 50 }, { 60, 20, 50 }, { 60, 40, 50 } }, LineOrganTool { Leaf::Edge })
            .empty())
        << "an edge without a bow is refused";
    EXPECT_EQ(shown({ { -80, 20, 50 }, { -41, 0, 50 }, { 5, 20, 50 } }, spiral(3)).size(),
              axes + organs + 3)
        << "three more below: plain leaves from foot to tip";
}

} // namespace
} // namespace tractus::lines
