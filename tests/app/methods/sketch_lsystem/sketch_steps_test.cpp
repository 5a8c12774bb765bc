#include "app/methods/sketch_lsystem/sketch_tool.h"

#include "app/stream/stream_output.h"
#include "app/view/station_view.h"
#include "tests/app/flat_station.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tractus::sketch {
namespace {

using Json = nlohmann::json;

// Returns the messages that other programs receive while a pen draws to the right and is lifted.
// The pen moves 2 mm every 5 ms.
std::vector<Json> steps_along_a_line(SketchTool const& tool, double length_mm,
                                     scene::Scene const& scene = {})
{
    auto station = flat_station(tool);
    std::vector<Json> lines;
    auto const write = [&](std::string_view line) {
        lines.push_back(Json::parse(line));
        return Result<void>();
    };
    auto output = stream::StreamOutput::open(write, {}, stream::StreamOutput::What::All).value();
    auto const take = [&] { ASSERT_TRUE(output.take(station, scene)); };
    int ms = 0;
    for (double x_mm = 0; x_mm <= length_mm; x_mm += 2, ms += 5) {
        station.push(kPen, at_ms(ms), pen_report(50 + x_mm, 50, true));
        take();
    }
    station.push(kPen, at_ms(ms), pen_report(50 + length_mm, 50, false));
    take();
    station.finish();
    take();
    return lines;
}

std::vector<Json> of_type(std::vector<Json> const& lines, std::string const& type)
{
    std::vector<Json> found;
    for (auto const& line : lines)
        if (line["type"] == type)
            found.push_back(line);
    return found;
}

SketchTool in_space()
{
    SketchTool tool;
    tool.first_length_mm = 30;
    tool.length_ratio = 0.9;
    tool.surface = StrokeSurface::Space;
    return tool;
}

// The rule is applied whenever the chord has grown by l, l r, l r^2, ... (Ijiri 2006, section 3).
// Along a straight line this happens at 30, 57, 81.3 and 103.17 mm.
TEST(SketchSteps, ComeWhenTheRuleIsApplied)
{
    auto const lines = steps_along_a_line(in_space(), 110);
    auto const steps = of_type(lines, "step");
    ASSERT_EQ(steps.size(), 4u);
    double const begin_mm = of_type(lines, "tip").front()["position_mm"][0];
    std::vector<double> const ends_mm { 30, 57, 81.3, 103.17 };
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(steps[i]["number"], i + 1);
        EXPECT_NEAR(double(steps[i]["position_mm"][0]) - begin_mm, ends_mm[i], 0.002);
        EXPECT_NEAR(steps[i]["position_mm"][2], 100, 0.002);
        // The step has the time of the first sample at or beyond its end; samples are 2 mm apart.
        EXPECT_NEAR(steps[i]["time_s"], 0.005 * std::ceil(ends_mm[i] / 2), 1e-9);
    }
}

TEST(SketchSteps, ComeBeforeTheirStroke)
{
    auto const lines = steps_along_a_line(in_space(), 110);
    auto const strokes = of_type(lines, "stroke");
    ASSERT_EQ(strokes.size(), 1u);
    bool has_ended = false;
    for (auto const& line : lines) {
        has_ended |= line["type"] == "stroke";
        if (line["type"] == "step") {
            EXPECT_FALSE(has_ended);
            EXPECT_EQ(line["stroke_time_s"], strokes[0]["tips"][0][4]);
        }
    }
}

TEST(SketchSteps, AreNoneOfAStrokeThatIsTooShort)
{
    auto const lines = steps_along_a_line(in_space(), 20);
    EXPECT_TRUE(of_type(lines, "step").empty());
    EXPECT_EQ(of_type(lines, "stroke").size(), 1u);
}

// With the card Birch, segments have the lengths of the model, whatever numbers the tool has. Each
// step must end at a node of the plant's trunk.
TEST(SketchSteps, EndAtAModelsNodes)
{
    auto tool = in_space();
    tool.card = SketchTool::Card::Birch;
    auto const steps = of_type(steps_along_a_line(tool, 110), "step");
    EXPECT_GT(steps.size(), 5u);
    auto drawn = station_on({}, tool);
    for (int i = 0; i <= 55; ++i)
        drawn.push(kPen, at_ms(5 * i), pen_report(50 + 2 * i, 50, true));
    drawn.push(kPen, at_ms(280), pen_report(160, 50, false));
    drawn.finish();
    auto const& scene = drawn.scene();
    ASSERT_EQ(scene.plants.size(), 1u);
    for (auto const& step : steps) {
        auto const& at = step["position_mm"];
        Vec3 const end_mm(at[0], at[1], at[2]);
        double nearest_mm = 1e9;
        for (auto const& node_mm : scene.base->positions(scene.base->axes.front()))
            nearest_mm
                = std::min(nearest_mm, (scene.placement.world_of_plant(node_mm) - end_mm).norm());
        EXPECT_LT(nearest_mm, 0.1) << step["number"];
    }
}

// On an upright sheet, a line drawn away from the user goes up from the ground.
TEST(SketchSteps, StandOnTheGroundOnPaper)
{
    auto tool = in_space();
    tool.surface = StrokeSurface::Paper;
    auto station = flat_station(tool);
    std::string text;
    auto const write = [&](std::string_view line) {
        if (line.find("\"step\"") != line.npos)
            text += line;
        return Result<void>();
    };
    auto output = stream::StreamOutput::open(write, {}, stream::StreamOutput::What::All).value();
    for (int i = 0; i <= 20; ++i)
        station.push(kPen, at_ms(5 * i), pen_report(50, 90 - 2 * i, true));
    ASSERT_TRUE(output.take(station, {}));
    auto const step = Json::parse(text);
    EXPECT_NEAR(step["position_mm"][1], 0, 0.002);
    EXPECT_NEAR(step["position_mm"][2], 30, 0.002);
}

TEST(SketchSteps, AreNoneWhereNumbersAreChanged)
{
    auto tool = in_space();
    tool.place = SketchTool::Place::Change;
    EXPECT_TRUE(of_type(steps_along_a_line(tool, 110), "step").empty());
}

// Between two applications of the rule, neither the preview's lines nor their display may be
// rebuilt.
TEST(SketchSteps, AreWhenThePreviewChanges)
{
    auto station = flat_station(in_space());
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    view::StationView view(station, document);
    auto draw_to = [&, i = 0](double x_mm) mutable {
        for (; 2 * i <= x_mm; ++i)
            station.push(kPen, at_ms(5 * i), pen_report(50 + 2 * i, 50, true));
        view.show(station, document);
        view.settle();
        return view.state().preview_revision;
    };
    auto const none = draw_to(28);
    auto const one = draw_to(34);
    EXPECT_NE(one, none);
    EXPECT_FALSE(view.state().preview.empty());
    EXPECT_EQ(draw_to(44), one);
    EXPECT_EQ(draw_to(54), one);
    EXPECT_NE(draw_to(60), one);
}

} // namespace
} // namespace tractus::sketch
