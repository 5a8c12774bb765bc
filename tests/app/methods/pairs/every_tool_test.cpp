#include "app/batch/drawing.h"
#include "app/batch/session_plant.h"
#include "app/controllers/replay_window.h"
#include "app/methods/all_methods.h"
#include "app/session/begin_empty.h"
#include "app/stream/stream_drawing.h"
#include "app/tools/tool_choices.h"
#include "drivers/logs/log_writer.h"
#include "engine/scene/back_picture.h"
#include "tests/app/commands/outcome.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"
#include "tests/app/methods/pictures/small_picture.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace tractus::methods {
namespace {

namespace fs = std::filesystem;

constexpr char const* kHeight = "100"; // Height of the surface in all logs of these tests, in mm.

// An initial state of a drawing, with the edits that make it.
struct Beginning {
    std::string name;
    std::vector<scene::Edit> edits;
};

std::vector<Beginning> beginnings()
{
    std::vector<Beginning> all { { "an empty sheet", { session::BeginEmpty {} } } };
    for (auto const& method : kMethods) {
        Steps steps(scene::apply_edit({}, scene::SetScale { 0.1 }).value());
        method.make(steps, 0);
        all.push_back({ method.name, { scene::SetScale { 0.1 } } });
        auto& edits = all.back().edits;
        edits.insert(edits.end(), steps.edits().begin(), steps.edits().end());
    }
    // A drawing with two plants, one of which is hidden, a picture, and a stroke for a selected
    // branch.
    Steps steps(scene::Scene {});
    load_model(steps, 60);
    load_model(steps, 0);
    steps.add(scene::HidePlant { steps.scene().plants.front()->drawn->id, true });
    steps.add(scene::LayPicture { "small.png", pictures::small_png(), {} });
    steps.add(scene::Select { { { 0, 1, 2 } } });
    steps.add(scene::Associate { stroke_through({ { 0, 0, 0 }, { 0, 0, 50 }, { 20, 0, 100 } }) });
    steps.add(scene::Indicate { { { 0, 0, 100 }, { 30, 0, 100 } }, {} });
    all.push_back({ "a drawing with several things", steps.edits() });
    return all;
}

// Returns every tool with its default options, and with every other word of each option in turn.
// The words of the last option come first, so that the growth brush ages a few trees before it
// grows one of each habit.
std::vector<tools::Tool> every_tool()
{
    std::vector<tools::Tool> all;
    for (auto const* const kind : all_methods().tools) {
        tools::Tool const usual(*kind);
        all.push_back(usual);
        auto const words = tools::word_settings(usual);
        for (std::size_t i = words.size(); i-- > 0;)
            for (std::size_t value = 0; value < words[i].option.words.size(); ++value)
                if (auto tool = tools::with_word(usual, i, static_cast<int>(value)); tool != usual)
                    all.push_back(std::move(tool));
    }
    return all;
}

// A recording of a hand that uses one tool after the other.
class HandLog {
public:
    HandLog()
        : writer_(out_, { .devices = { drivers::simple_pen() } })
    {
    }

    void take(tools::Tool const& tool)
    {
        auto const words = tools::words_for(tool);
        writer_.write_tool(at_ms(time_ms_), words.name, words.arguments);
    }

    void take(std::string_view word, std::string_view arguments)
    {
        writer_.write_tool(at_ms(time_ms_), word, arguments);
    }

    // Draws a stroke through positions on the tablet and lifts the pen.
    void draw(std::vector<Vec2> const& places_mm)
    {
        for (std::size_t i = 1; i < places_mm.size(); ++i)
            for (int k = 0; k < 8; ++k)
                report(places_mm[i - 1] + (places_mm[i] - places_mm[i - 1]) * k / 8, true);
        report(places_mm.back(), false);
        time_ms_ += 300;
        report(places_mm.back(), false);
    }

    // Draws three strokes: one upwards on the tablet, one from the middle to the right, and one
    // around both.
    void draw_all()
    {
        draw({ { 100, 95 }, { 101, 50 }, { 99, 20 } });
        draw({ { 100, 50 }, { 140, 52 } });
        draw({ { 101, 90 }, { 70, 60 }, { 80, 15 }, { 120, 15 }, { 130, 60 }, { 100, 90 } });
    }

    std::string text()
    {
        EXPECT_TRUE(writer_.flush());
        return out_.str();
    }

private:
    void report(Vec2 const& at_mm, bool touching)
    {
        writer_.write_report(0, at_ms(time_ms_ += 5), pen_report(at_mm.x(), at_mm.y(), touching));
    }

    std::ostringstream out_;
    drivers::LogWriter writer_;
    std::int64_t time_ms_ = 100;
};

// Returns a log in which a tool is chosen. Unless the tool acts at once, it is then used for
// drawing.
std::string log_with(tools::Tool const& tool)
{
    HandLog log;
    log.take(tool);
    if (!tool.is_done_at_once())
        log.draw_all();
    else
        log.draw({ { 10, 10 }, { 12, 10 } }); // Draws one more stroke, with the current tool.
    return log.text();
}

// Fixture for tests with files in a temporary folder.
class EveryTool : public session::SessionFolder {
protected:
    fs::path write_log(std::string const& text) const
    {
        write_bytes("a.tractus-log", text);
        return path("a.tractus-log");
    }

    batch::Drawing draw(fs::path const& log, scene::Scene const& scene) const
    {
        terminal::Progress progress;
        batch::DrawingReport report;
        auto drawing = batch::read_drawing(
            { .log = log, .methods = all_methods(), .height = kHeight }, scene, progress, report);
        EXPECT_TRUE(drawing) << drawing.error().message;
        std::size_t refused = 0;
        for (auto const& drawn : drawing->strokes)
            refused += !drawn.refusal.empty();
        std::size_t noted = 0;
        for (auto const& note : report.notes)
            noted += note.find(" changed nothing: ") != std::string::npos;
        EXPECT_EQ(noted, refused);
        return *std::move(drawing);
    }
};

station::ReplayOptions replay_options()
{
    return { .methods = all_methods(),
             .rig = {},
             .height = calib::parse_height_scenario(kHeight).value() };
}

// True if a file can be made from the scene. That is impossible if all of its plants are hidden.
bool is_any_shown(scene::Scene const& scene)
{
    auto const& plants = scene.plants;
    return plants.empty() || std::any_of(plants.begin(), plants.end(), [](auto const& plant) {
               return !plant->drawn->is_hidden;
           });
}

// The window must show why the last stroke was refused, except while it must report that the plant
// has lost branches.
void check_window(drivers::Log const& log, scene::Scene const& scene, batch::Drawing const& drawing)
{
    auto window
        = controllers::ReplayWindow::create(log, replay_options(), scene, fs::temp_directory_path())
              .value();
    std::string status;
    while (window.state().playing) {
        window.advance(std::chrono::milliseconds(100));
        window.settle();
        if (window.state().playing)
            status = window.state().status;
    }
    auto const& last = drawing.strokes.back();
    if (!last.refusal.empty() && !status.starts_with("The plant has lost"))
        EXPECT_EQ(status, last.refusal);
}

// Every line of the stream must be JSON, and the last line must mark the end.
void check_stream(drivers::Log const& log)
{
    auto replay = station::LogReplay::create(log, replay_options()).value();
    std::vector<std::string> types;
    auto const write = [&](std::string_view line) {
        types.push_back(nlohmann::json::parse(line).at("type"));
        return Result<void>();
    };
    auto output = stream::StreamOutput::open(write, replay.station().volume_mm(),
                                             stream::StreamOutput::What::All)
                      .value();
    std::atomic<bool> const stop = false;
    ASSERT_TRUE(stream::stream_log(replay, output, std::nullopt, stop));
    EXPECT_EQ(types.front(), "stream");
    EXPECT_EQ(types.back(), "end");
}

// If a stroke is refused, the command line, the window and the stream must all refuse it with the
// same message. If it is accepted, the plant can be exported.
TEST_F(EveryTool, MeansTheSameWhateverReplaysIt)
{
    // For each tool, by its word: whether any of its strokes was accepted, and whether any was
    // refused.
    std::map<std::string, std::pair<bool, bool>> outcomes;
    for (auto const& [name, edits] : beginnings()) {
        auto const scene = scene::apply_edits({}, edits).value();
        for (auto const& usual : every_tool())
            for (bool const at_once : { false, true }) {
                if (at_once && !usual.needs_no_stroke())
                    continue;
                auto const tool = at_once ? usual.done_at_once() : usual;
                auto const words = tools::words_for(tool);
                SCOPED_TRACE(fmt::format("{} {} on {}", words.name, words.arguments, name));
                auto const text = log_with(tool);
                auto const drawing = draw(write_log(text), scene);
                ASSERT_EQ(drawing.strokes.size(), at_once ? 2u : 3u);
                bool is_changed = false;
                for (auto const& drawn : drawing.strokes) {
                    is_changed |= drawn.refusal.empty();
                    if (drawn.tool == tool)
                        (drawn.refusal.empty() ? outcomes[words.name].first
                                               : outcomes[words.name].second)
                            = true;
                }
                if (is_changed && is_any_shown(drawing.scene))
                    EXPECT_FALSE(exported(drawing.scene).empty());
                auto const log = drivers::parse_log(text, "hand").value();
                if (at_once || usual == tools::Tool(usual.kind()))
                    check_window(log, scene, drawing);
                check_stream(log);
            }
    }
    // These tools need a leaf with more lines, a crown in space, a plant on another plant, or the
    // wood of a grown tree under the stroke. They have tests of their own.
    std::set<std::string> const needs_more { "erase_crown", "erase_leaf", "graft_plant",
                                             "prune_brush", "take_off" };
    for (auto const& [word, outcome] : outcomes) {
        EXPECT_NE(outcome.first, needs_more.contains(word)) << word;
        // "leaf_line" may never be refused, since any line can begin a leaf.
        EXPECT_TRUE(outcome.second || word == "leaf_line") << word;
    }
}

// Every command that replays a recording must accept one in which all tools are used.
TEST_F(EveryTool, GoesThroughEveryCommandThatReplays)
{
    HandLog log;
    for (auto const& tool : every_tool()) {
        if (tool.needs_no_stroke()) {
            log.take(tool.done_at_once());
            // The tool has acted, so it draws no stroke. Further strokes would only make the
            // forests older.
            continue;
        }
        log.take(tool);
        log.draw({ { 100, 95 }, { 101, 50 }, { 99, 20 } });
    }
    auto const hand = write_log(log.text()).string();
    for (auto const& [name, edits] : beginnings()) {
        SCOPED_TRACE(name);
        auto const plant = path("plant.tractus").string();
        fs::remove(plant);
        ASSERT_TRUE(batch::begin_session(plant, edits, all_methods().edits));
        std::vector<std::vector<std::string>> const commands {
            { "replay", hand, "--plant", plant, "--count", "1", "-o", path("replayed").string() },
            { "vary", plant, "--drawing", hand, "--count", "1", "-o", path("varied").string() },
            { "grow", plant, "--drawing", hand, "-o", path("grown.glb").string() },
            { "stream", "--strokes", hand },
            { "convert", hand, "-o", path("strokes.txt").string() },
        };
        for (auto arguments : commands) {
            arguments.insert(arguments.end(), { "--height", kHeight });
            auto const outcome = commands::run(arguments);
            EXPECT_EQ(outcome.exit_code, 0) << arguments.front() << ": " << outcome.err;
        }
    }
}

TEST_F(EveryTool, ThatNeedsAStrokeIsRefusedWithoutOne)
{
    for (auto const& tool : every_tool()) {
        if (tool.needs_no_stroke())
            continue;
        auto const words = tools::words_for(tool);
        HandLog log;
        log.take(words.name, words.arguments + " now");
        log.draw_all();
        auto const replay = station::LogReplay::create(
            drivers::parse_log(log.text(), "hand").value(), replay_options());
        ASSERT_FALSE(replay) << words.name;
        EXPECT_EQ(replay.error().fault, Fault::User);
        EXPECT_NE(replay.error().message.find(words.name), std::string::npos);
    }
}

// Every command must handle a drawing without plants like any other.
TEST_F(EveryTool, AnEmptySheetGoesThroughEveryCommand)
{
    HandLog log;
    log.draw_all(); // The current tool shapes branches, although there are none.
    auto const hand = write_log(log.text()).string();
    auto const kept = path("kept.tractus").string();
    auto const out = [&](char const* name) { return path(name).string(); };
    std::vector<std::vector<std::string>> const commands {
        { "replay", hand, "--plant", "empty", "--count", "1", "--height", kHeight, "--session",
          kept, "-o", out("one") },
        { "replay", hand, "--plant", "empty", "--count", "7", "--height", kHeight, "--seasons",
          "--age", "0.5", "-o", out("seven") },
        { "replay", hand, "--plant", kept, "--count", "2", "--height", kHeight, "-o",
          out("again") },
        { "vary", kept, "--count", "3", "--sheet", out("sheet.png"), "--lods", "2", "--wind",
          "attributes", "-o", out("vary.glb") },
        { "vary", kept, "--count", "2", "--spread", "scatter", "--ages", "0.2..1", "-o",
          out("folder") },
        { "grow", kept, "-o", out("grown.glb") },
        { "grow", kept, "-o", out("grown.obj") },
        { "grow", kept, "-o", out("grown.mtg") },
        { "grow", kept, "-o", out("grown.png") },
        { "render", out("grown.glb"), "-o", out("rendered.png") },
        { "session", "info", kept },
        { "session", "log", kept },
        { "session", "export", kept, "-o", out("exported") },
        { "session", "repair", kept, "-o", out("repaired.tractus") },
        { "session", "info", out("repaired.tractus") },
    };
    for (auto const& arguments : commands) {
        auto const outcome = commands::run(arguments);
        EXPECT_EQ(outcome.exit_code, 0)
            << fmt::format("{}: {}", fmt::join(arguments, " "), outcome.err);
    }
}

} // namespace
} // namespace tractus::methods
