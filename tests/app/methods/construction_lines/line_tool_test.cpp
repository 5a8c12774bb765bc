#include "app/methods/construction_lines/line_tool.h"

#include "app/methods/construction_lines/layer_nodes_tool.h"
#include "app/methods/construction_lines/line_layers.h"
#include "app/methods/construction_lines/line_pattern_tool.h"
#include "app/methods/construction_lines/line_previewer.h"
#include "app/methods/construction_lines/line_role_tool.h"
#include "app/session/edit_record.h"
#include "app/session/session.h"
#include "app/view/station_view.h"
#include "engine/base/file.h"
#include "engine/methods/construction_lines/line_model.h"
#include "tests/app/commands/outcome.h"
#include "tests/app/flat_station.h"
#include "tests/app/methods/construction_lines/drawn_frond.h"
#include "tests/app/replayed.h"
#include "tests/app/simulated_drawing.h"

#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace tractus::lines {
namespace {

namespace fs = std::filesystem;
using namespace line_tests;
using lines::Pattern;
using lines::Role;

TEST(LineTool, SaysItsOptionsInLogs)
{
    EXPECT_EQ(line_of(LineTool {}), "construction_line height together");
    EXPECT_EQ(line_of(LineTool { .depth_by = lines::DepthBy::StemsHeight,
                                 .reading = lines::Reading::OneByOne }),
              "construction_line ")
        << "as older logs mean it";
    EXPECT_EQ(line_of(LineTool { .depth_by = lines::DepthBy::Pressure }),
              "construction_line pressure together");
    EXPECT_EQ(line_of(LineTool { .plant = LineTool::Plant::NewStem,
                                 .depth_by = lines::DepthBy::StemsHeight,
                                 .nodes = 12,
                                 .pattern = Pattern::Kind::Whorled,
                                 .divergence_deg = 99.5,
                                 .organs = 5 }),
              "construction_line new_stem whorled together nodes=12 divergence=99.5 organs=5");
    EXPECT_EQ(line_of(LineTool { .plant = LineTool::Plant::AnotherStem }),
              "construction_line another_stem height together");
    EXPECT_EQ(line_of(tools::Tool(LinePatternTool {}).done_at_once()), "line_pattern now");
    EXPECT_EQ(line_of(tools::Tool(LayerNodesTool { LayerNodesTool::What::Fewer }).done_at_once()),
              "layer_nodes fewer now");
    EXPECT_EQ(line_of(LayerNodesTool { .nodes = 30 }), "layer_nodes count=30");
    EXPECT_EQ(line_of(LineRoleTool { .role = Role::Left }), "line_role left");
    EXPECT_EQ(line_of(LineRoleTool { .role = Role::Around }), "line_role around");
    EXPECT_EQ(line_of(LineRoleTool { .turn_round = true }), "line_role turned");
    EXPECT_NE(tools::parse_tool(methods::all_methods().tools, "construction_line", "nodes=501")
                  .error()
                  .message.find("from 0 to 500"),
              std::string::npos);
}

tools::Tool another_stem()
{
    return LineTool { .plant = LineTool::Plant::AnotherStem, .nodes = 6 };
}

// Draws a frond, another frond beside it, and a lateral axis on the first frond.
void draw_two_stems_and_a_lateral(document::Document& document)
{
    draw_frond(document);
    document.draw(
        { stroke_through({ { 50, -60, 50 }, { 52, 0, 50 }, { 58, 40, 50 } }), another_stem() });
    document.draw(
        { stroke_through({ { -39, 20, 50 }, { 0, 30, 50 }, { 30, 50, 50 } }), another_stem() });
}

TEST(LineTool, BeginsAPlantAndGoesOnWithIt)
{
    auto const scene = small_scene();
    document::Document document(scene, document::Document::Working::AtOnce);
    draw_frond(document);
    auto const drawn = document.take_finished_strokes();
    ASSERT_EQ(drawn.size(), 5U);
    for (auto const& stroke : drawn)
        EXPECT_EQ(stroke.refusal, "");
    auto const& after = document.newest()->scene;
    ASSERT_EQ(after.plants.size(), 2U);
    EXPECT_EQ(after.plants[0], scene.plants[0]) << "it stays as it was";
    EXPECT_EQ(after.placement.scale, scene.placement.scale);
    EXPECT_EQ(after.base->organs.size(), 7U);
    document.draw({ frond()[0], LineTool { .plant = LineTool::Plant::NewStem } });
    EXPECT_EQ(document.newest()->scene.plants.size(), 3U);
}

TEST(LineTool, DrawsSeveralStemsOfOnePlant)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_two_stems_and_a_lateral(document);
    auto const drawn = document.take_finished_strokes();
    for (auto const& stroke : drawn)
        EXPECT_EQ(stroke.refusal, "");
    auto const& after = document.newest()->scene;
    ASSERT_EQ(after.plants.size(), 1U);
    EXPECT_EQ(after.base->organs.size(), 3U * 7) << "seven nodes on each";
    EXPECT_EQ(drawn[5].message,
              "This is another stem: what grows on the other one grows on it, too, until you draw "
              "a boundary beside it");
    EXPECT_EQ(drawn[6].message.substr(0, 42), "This is a stem that stands on another one:");
    auto const& axes = after.base->axes;
    ASSERT_EQ(axes.size(), 3U);
    EXPECT_EQ(axes[0].parent_axis, kNone);
    EXPECT_EQ(axes[1].parent_axis, 0U) << "the lateral axis";
    EXPECT_EQ(axes[2].parent_axis, kNone);
    // The stem is vertical where it was drawn.
    Vec3 const top_mm = after.placement.world_of_plant(after.base->positions(axes[2]).back());
    EXPECT_NEAR((top_mm - Vec3(58, 0, 100)).norm(), 0, 0.5);
    EXPECT_EQ(kStemLayer.lines(after).size(), 2U);
    EXPECT_EQ(kOtherStemLayer.lines(after).size(), 1U);
    document.undo();
    EXPECT_EQ(document.newest()->scene.base->organs.size(), 2U * 7);
    document.undo();
    EXPECT_EQ(document.newest()->scene.base->organs.size(), 7U);
    document.redo();
    document.redo();
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, after.base->node_position_mm);
}

// A line drawn beside the second stem belongs to that stem. The lines of the stems have alternating
// colours, and each stem has functions of its own.
TEST(LineTool, GivesLinesToTheStemBesideWhichTheyAreDrawn)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_two_stems_and_a_lateral(document);
    document.draw({ stroke_through({ { 80, -58, 50 }, { 84, 0, 50 }, { 75, 45, 50 } }), spiral() });
    auto const& scene = document.newest()->scene;
    auto const& sketch = *lines::active_pen_sketch(scene.state);
    EXPECT_EQ(sketch.lines.back().role, Role::Right);
    EXPECT_EQ(sketch.lines.back().stem, 1U);
    EXPECT_EQ(kBoundaryLayer.lines(scene).size(), 2U);
    EXPECT_EQ(kOtherBoundaryLayer.lines(scene).size(), 1U);
    EXPECT_EQ(lines::current_stem(sketch).value(), 1U);
    EXPECT_EQ(lines::model_of(sketch)->functions.size(), 3U * 2 + 2 * 5);
    EXPECT_EQ(kLinesToDrawLayer.lines(scene).size(), 3U) << "of the stem in hand";
}

// Fixture for comparing the drawn plant with the model that `tractus construct` writes from the
// same strokes.
class LineToolAndCommand : public testing::Test {
protected:
    LineToolAndCommand() { fs::create_directories(folder_); }
    ~LineToolAndCommand() override { fs::remove_all(folder_); }
    LineToolAndCommand(LineToolAndCommand const&) = delete;
    LineToolAndCommand& operator=(LineToolAndCommand const&) = delete;

    std::string path(std::string const& name) const { return (folder_ / name).string(); }

    // Runs `tractus construct` on the positions of the strokes on the tablet, and returns its
    // report.
    nlohmann::json construct(std::vector<Stroke> const& strokes,
                             std::vector<int> const& nodes) const
    {
        nlohmann::json file { { "pattern", "spiral" }, { "nodes_per_layer", nodes } };
        for (auto const& stroke : strokes) {
            nlohmann::json line;
            for (auto const& tip : stroke.tips)
                line.push_back({ tip.position_mm.x(), tip.position_mm.y() });
            file["strokes"].push_back(line);
        }
        EXPECT_TRUE(write_file(path("lines.json"), file.dump()));
        auto const outcome = commands::run(
            { "construct", path("lines.json"), "--smooth", "--report", "-o", path("out") });
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_line_tool_" + std::to_string(::getpid()));
};

TEST_F(LineToolAndCommand, GiveTheSameText)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    construct(frond(), { 6 });
    auto const model
        = lines::model_of(*lines::active_pen_sketch(document.newest()->scene.state)).value();
    EXPECT_EQ(model.source.text, read_file(path("out/lines.l")).value());
    // The written view has an additional line for cpfg.
    EXPECT_EQ(model.source.view_text + "surface: l lines_leaf.s 1\n",
              read_file(path("out/lines.v")).value());
    ASSERT_EQ(model.functions.size(), 7U);
    for (auto const& [name, text] : model.functions)
        EXPECT_EQ(text, read_file(path("out/" + name)).value()) << name;
}

// Returns the strokes of a frond, and of boundaries in front of it and behind it. In the front
// view, these boundaries lie on the stem.
std::vector<Stroke> frond_in_space()
{
    auto strokes = frond();
    strokes.push_back(
        stroke_through({ { -40, -58, 50 }, { -41, 0, 95 }, { -38, 40, 85 }, { -36, 63, 55 } }));
    strokes.push_back(
        stroke_through({ { -39, -58, 50 }, { -41, 0, 20 }, { -38, 40, 25 }, { -36, 63, 48 } }));
    return strokes;
}

void draw_frond_in_space(document::Document& document)
{
    for (auto const& stroke : frond_in_space())
        document.draw({ stroke, spiral() });
}

TEST(LineTool, DrawsBoundariesWhileTheSurfaceMoves)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond_in_space(document);
    auto const drawn = document.take_finished_strokes();
    EXPECT_EQ(drawn[5].message.substr(0, 38), "This is a boundary in space, in front,");
    auto const& after = document.newest()->scene;
    auto const& sketch = *lines::active_pen_sketch(after.state);
    EXPECT_EQ(sketch.lines[5].role, Role::Around);
    EXPECT_EQ(sketch.lines[6].role, Role::Around);
    EXPECT_EQ(kBoundaryLayer.lines(after).size(), 4U);
    EXPECT_EQ(kStemLayer.lines(after).size(), 1U);
    EXPECT_TRUE(kLinesToDrawLayer.lines(after).empty());
    // In logs of older versions, a stroke redraws the stem where it would now be a boundary in
    // space.
    document::Document older(scene::Scene {}, document::Document::Working::AtOnce);
    for (auto const& stroke : frond_in_space())
        older.draw({ stroke,
                     tools::parse_tool(methods::all_methods().tools, "construction_line", "spiral")
                         .value() });
    for (auto const& line : lines::active_pen_sketch(older.newest()->scene.state)->lines)
        EXPECT_NE(line.role, Role::Around);
}

// The plant must be the model that `tractus construct` writes from the same strokes in space.
TEST_F(LineToolAndCommand, GiveTheSameTextOfBoundariesInSpace)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond_in_space(document);
    nlohmann::json file { { "pattern", "spiral" }, { "nodes_per_layer", { 6 } } };
    for (auto const& stroke : frond_in_space()) {
        nlohmann::json line;
        for (auto const& tip : stroke.tips)
            line.push_back({ tip.position_mm.x(), tip.position_mm.y(), tip.position_mm.z() - 50 });
        file["strokes"].push_back(line);
    }
    ASSERT_TRUE(write_file(path("lines.json"), file.dump()));
    auto const outcome = commands::run(
        { "construct", path("lines.json"), "--smooth", "--report", "-o", path("out") });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["roles"][5], "around");
    ASSERT_EQ(report["boundaries"].size(), 4U);
    EXPECT_EQ(report["boundaries"][0]["azimuth"], 0);
    auto const model
        = lines::model_of(*lines::active_pen_sketch(document.newest()->scene.state)).value();
    EXPECT_EQ(model.source.text, read_file(path("out/lines.l")).value());
    ASSERT_EQ(model.functions.size(), 11U);
    for (auto const& [name, text] : model.functions)
        EXPECT_EQ(text, read_file(path("out/" + name)).value()) << name;
}

// Returns a recording in which the simulated hand, with tremor, draws a sketch with the line tool.
drivers::Log recorded_sketch()
{
    constexpr std::string_view kHand = R"(
version = 1
seed = 5
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [20, -60, 50]
to_mm = [30, 60, 50]
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [-15, -60, 50]
to_mm = [0, 70, 50]
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [70, 70, 50]
to_mm = [50, -60, 50]
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [-30, -20, 50]
to_mm = [80, -40, 50]
[[gesture]]
tool = "draw"
propagation = "both"
path = "line"
from_mm = [-30, 30, 50]
to_mm = [90, 45, 50]
)";
    auto log = recorded_log(kHand);
    for (auto& tool : log.tools) {
        tool.tool = "construction_line";
        tool.arguments = "spiral together nodes=7";
    }
    return log;
}

TEST_F(LineToolAndCommand, GiveTheSamePlantFromALog)
{
    auto const replay = replayed(recorded_sketch());
    ASSERT_EQ(replay.strokes.size(), 5U);
    std::vector<Stroke> strokes;
    for (auto const& drawn : replay.strokes) {
        EXPECT_EQ(drawn.refusal, "");
        strokes.push_back(drawn.stroke);
    }
    ASSERT_EQ(replay.scene.plants.size(), 2U);
    auto const report = construct(strokes, { 7 });
    auto const& plant = *replay.scene.base;
    ASSERT_EQ(plant.organs.size(), 8U);
    ASSERT_EQ(report["leaf_tips"].size(), 8U);
    auto const* const sketch = lines::active_pen_sketch(replay.scene.state);
    double const foot_mm = lines::stem_sketches(*sketch)->front().sketch.stem.front().y();
    double const length_mm = report["stem_length"].get<double>();
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        auto const& organ = plant.organs[i];
        double const reach_mm
            = plant.organ_shapes[organ.shape].length_mm * static_cast<double>(organ.scale.y());
        Vec3 const tip_mm = replay.scene.placement.world_of_plant(
            organ.position_mm + organ.orientation * Vec3(0, reach_mm, 0));
        auto const& expected = report["leaf_tips"][i];
        Vec3 const there_mm(expected[0].get<double>(), -expected[2].get<double>(),
                            expected[1].get<double>() - foot_mm);
        EXPECT_LE((tip_mm - there_mm).norm(), 0.001 * length_mm) << "organ " << i;
    }
}

// Draws a plant in a session, changes it with several tools, and returns the final scene.
scene::Scene drawn_in(session::Session session,
                      void (*draw)(document::Document& document) = draw_frond)
{
    document::Document document(std::move(session), document::Document::Working::AtOnce);
    draw(document);
    document.draw({ {}, tools::Tool(LinePatternTool {}).done_at_once() });
    document.draw(
        { {}, tools::Tool(LayerNodesTool { LayerNodesTool::What::More }).done_at_once() });
    document.draw(
        { stroke_through({ { -60, 0, 50 }, { -74, 0, 50 } }), LineRoleTool { Role::Unsure } });
    for (auto const& drawn : document.take_finished_strokes()) {
        EXPECT_EQ(drawn.refusal, "");
        for (auto const& edit : drawn.edits) {
            auto const record = session::record_of(edit);
            auto const again = session::edit_of(record, methods::all_methods().edits).value();
            EXPECT_EQ(session::record_of(again).fields, record.fields);
            EXPECT_EQ(session::record_of(again).numbers, record.numbers);
            EXPECT_EQ(again.describe(), edit.describe());
        }
    }
    document.undo();
    return document.newest()->scene;
}

TEST_F(LineToolAndCommand, ASessionKeepsTheSketch)
{
    auto const options = session::session_by_the_clock(methods::all_methods().edits,
                                                       [] { return scene::LoadOptions {}; });
    auto const before = drawn_in(
        session::Session::create(path("lines.tractus"), { .plant = "small.l", .program = "1" },
                                 std::vector<scene::Edit> { small_model() }, options)
            .value());
    auto const again = session::Session::open(path("lines.tractus"), options).value();
    EXPECT_EQ(again.unknown().count, 0U);
    ASSERT_EQ(again.scene().plants.size(), 2U);
    EXPECT_EQ(again.scene().base->node_position_mm, before.base->node_position_mm);
    ASSERT_EQ(again.scene().base->organs.size(), 8U);
    for (std::size_t i = 0; i < 8; ++i)
        EXPECT_EQ(again.scene().base->organs[i].position_mm, before.base->organs[i].position_mm);
    auto const log = commands::run({ "session", "log", path("lines.tractus") });
    EXPECT_NE(log.out.find("begins a plant of construction lines, spiral"), std::string::npos)
        << log.out << log.err;
    EXPECT_NE(log.out.find("alternate, 180 degrees"), std::string::npos) << log.out;
}

TEST_F(LineToolAndCommand, ASessionKeepsBoundariesInSpace)
{
    auto const options = session::session_by_the_clock(methods::all_methods().edits,
                                                       [] { return scene::LoadOptions {}; });
    auto const before = drawn_in(
        session::Session::create(path("space.tractus"), { .plant = "small.l", .program = "1" },
                                 std::vector<scene::Edit> { small_model() }, options)
            .value(),
        draw_frond_in_space);
    auto const again = session::Session::open(path("space.tractus"), options).value();
    EXPECT_EQ(again.unknown().count, 0U);
    auto const* const sketch = lines::active_pen_sketch(again.scene().state);
    ASSERT_TRUE(sketch);
    EXPECT_EQ(sketch->lines[5].role, Role::Around);
    EXPECT_EQ(lines::model_of(*sketch)->functions,
              lines::model_of(*lines::active_pen_sketch(before.state))->functions);
}

TEST_F(LineToolAndCommand, ASessionKeepsStemsAndWhatTheyStandOn)
{
    auto const options = session::session_by_the_clock(methods::all_methods().edits,
                                                       [] { return scene::LoadOptions {}; });
    auto const before = drawn_in(
        session::Session::create(path("stems.tractus"), { .plant = "small.l", .program = "1" },
                                 std::vector<scene::Edit> { small_model() }, options)
            .value(),
        draw_two_stems_and_a_lateral);
    auto const again = session::Session::open(path("stems.tractus"), options).value();
    EXPECT_EQ(again.unknown().count, 0U);
    ASSERT_EQ(again.scene().plants.size(), 2U);
    EXPECT_EQ(again.scene().base->axes.size(), 3U);
    EXPECT_EQ(again.scene().base->node_position_mm, before.base->node_position_mm);
    auto const log = commands::run({ "session", "log", path("stems.tractus") });
    EXPECT_NE(log.out.find("adds another stem to plant"), std::string::npos) << log.out << log.err;
}

TEST_F(LineToolAndCommand, GiveTheSameTextOfSeveralStems)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_two_stems_and_a_lateral(document);
    nlohmann::json file { { "pattern", "spiral" }, { "nodes_per_layer", { 6 } } };
    for (auto const& drawn : document.take_finished_strokes()) {
        nlohmann::json line;
        for (auto const& tip : drawn.stroke.tips)
            line.push_back({ tip.position_mm.x(), tip.position_mm.y() });
        auto& strokes = file["strokes"];
        if (strokes.size() < 5)
            strokes.push_back(line);
        else
            strokes.push_back(nlohmann::json::object({ { "stem", line } }));
    }
    ASSERT_TRUE(write_file(path("lines.json"), file.dump()));
    auto const outcome = commands::run(
        { "construct", path("lines.json"), "--smooth", "--report", "-o", path("out") });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const model
        = lines::model_of(*lines::active_pen_sketch(document.newest()->scene.state)).value();
    EXPECT_EQ(model.source.text, read_file(path("out/lines.l")).value());
    // The written view has an additional line for cpfg.
    EXPECT_EQ(model.source.view_text + "surface: l lines_leaf.s 1\n",
              read_file(path("out/lines.v")).value());
    ASSERT_EQ(model.functions.size(), 3U * 2 + 5);
    for (auto const& [name, text] : model.functions)
        EXPECT_EQ(text, read_file(path("out/" + name)).value()) << name;
}

// A recording must contain which of its strokes begin a new stem.
TEST(LineTool, BeginsStemsInARecording)
{
    auto log = recorded_sketch();
    log.tools[1].arguments = "another_stem nodes=7";
    auto const replay = replayed(log);
    ASSERT_EQ(replay.strokes.size(), 5U);
    for (auto const& drawn : replay.strokes)
        EXPECT_EQ(drawn.refusal, "");
    EXPECT_EQ(replay.scene.base->axes.size(), 2U);
    EXPECT_EQ(replay.scene.base->organs.size(), 2U * 8);
}

// Each drawn line is one step that can be undone.
TEST(LineTool, IsUndoneAndDoneAgain)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    draw_frond(document);
    auto const drawn = document.newest();
    auto const lines_of = [&] {
        auto const* const sketch = lines::active_pen_sketch(document.newest()->scene.state);
        return sketch ? sketch->lines.size() : 0;
    };
    for (std::size_t left = 5; left-- > 0;) {
        document.undo();
        EXPECT_EQ(lines_of(), left);
    }
    EXPECT_TRUE(document.newest()->scene.plants.empty());
    for (int i = 0; i < 5; ++i)
        document.redo();
    EXPECT_EQ(lines_of(), 5U);
    EXPECT_EQ(document.newest()->scene.base->node_position_mm, drawn->scene.base->node_position_mm);
}

TEST(LineTool, SaysWhatTheLineWasTakenForAndWhatIsMissing)
{
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    document.draw({ frond()[0], spiral() });
    document.draw({ stroke_through({ { 80, 0, 50 }, { 90, 10, 50 } }), spiral() });
    document.draw({ stroke_through({ { 80, 0, 50 }, { 80, 0, 50 } }), spiral() });
    auto const drawn = document.take_finished_strokes();
    ASSERT_EQ(drawn.size(), 3U);
    EXPECT_EQ(drawn[0].message,
              "This is the stem: draw a boundary on its left or right, the line that the leaves' "
              "tips reach, such as the dotted ones");
    EXPECT_EQ(drawn[1].message.substr(0, 37), "It has no effect: this line neither c");
    EXPECT_EQ(drawn[2].refusal, "this is only a dot: draw a line of the sketch");
    auto const station = flat_station();
    view::StationView view(station, document);
    view.tell(drawn[0]);
    EXPECT_EQ(view.state().status, drawn[0].message);
    view.tell(drawn[2]);
    EXPECT_EQ(view.state().status, drawn[2].refusal);
}

// The preview under the pen must be equal to the plant that results from the stroke.
TEST(LineTool, ShowsThePlantThatFollows)
{
    auto const strokes = frond();
    auto scene = small_scene();
    for (std::size_t i = 0; i < 4; ++i)
        scene = scene::apply_edits(scene, spiral().edits_for(strokes[i], scene).value()).value();
    auto const shared = std::make_shared<scene::Scene const>(scene);
    auto const tool = spiral(30);
    auto const shown = line_previewer()->show({ shared, tool, strokes[4].tips.vector(), 99 });
    auto const after = scene::apply_edits(scene, tool.edits_for(strokes[4], scene).value()).value();
    ASSERT_EQ(shown.size(), 1 + after.base->organs.size());
    for (std::size_t i = 0; i < after.base->organs.size(); ++i) {
        Vec3 const foot_mm
            = scene.placement.world_of_plant(shown[i + 1].points_mm[0].cast<double>());
        Vec3 const there_mm = after.placement.world_of_plant(after.base->organs[i].position_mm);
        EXPECT_NEAR((foot_mm - there_mm).norm(), 0, 0.05);
    }
    auto const dot = stroke_through({ { 0, 0, 0 }, { 0, 0, 0 } });
    EXPECT_TRUE(line_previewer()->show({ shared, tool, dot.tips.vector(), 99 }).empty());
}

} // namespace
} // namespace tractus::lines
