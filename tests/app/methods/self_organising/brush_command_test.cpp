#include "app/batch/drawing.h"
#include "app/batch/session_plant.h"
#include "app/terminal/progress.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tractus::self_organising {
namespace {

namespace fs = std::filesystem;

class BrushCommand : public ::testing::Test {
protected:
    BrushCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream strokes(folder_ / "up.txt");
        for (int i = 0; i <= 40; ++i)
            strokes << "10 20 " << 5 + 3 * i << "\n";
        strokes << "\n";
        for (int i = 0; i <= 40; ++i)
            strokes << 10 + 2 * i << " 20 120\n";
    }
    ~BrushCommand() override { fs::remove_all(folder_); }

    std::string path(char const* name) const { return (folder_ / name).string(); }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_brush_command." + std::to_string(getpid()));
};

TEST_F(BrushCommand, GrowsATreeAlongStrokes)
{
    auto const brush = [&](char const* file, char const* seed) {
        auto const outcome = commands::run({ "brush", path("up.txt"), "--habit", "oak", "--years",
                                             "18", "--seed", seed, "-o", path(file) });
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_NE(outcome.out.find(": 2 strokes, "), std::string::npos) << outcome.out;
        return file_bytes(path(file));
    };
    auto const graph = brush("one.mtg", "1");
    EXPECT_GT(graph.size(), 10'000U);
    EXPECT_EQ(brush("again.mtg", "1"), graph);
    EXPECT_NE(brush("other.mtg", "2"), graph);
    EXPECT_EQ(brush("tree.glb", "1").substr(0, 4), "glTF");
}

TEST_F(BrushCommand, BeginsASessionThatGivesTheSameTree)
{
    ASSERT_EQ(commands::run({ "brush", path("up.txt"), "--years", "18", "-o", path("one.mtg") })
                  .exit_code,
              0);
    ASSERT_EQ(commands::run({ "brush", path("up.txt"), "--years", "18", "-o", path("t.tractus") })
                  .exit_code,
              0);
    auto const grown = commands::run(
        { "grow", path("t.tractus"), "-o", path("two.mtg"), "--growth", "as drawn" });
    ASSERT_EQ(grown.exit_code, 0) << grown.err;
    auto const scene
        = batch::load_session_scene(path("t.tractus"), methods::all_methods().edits).value();
    EXPECT_GT(scene.base->segment_count(), 200U);
    auto const log = commands::run({ "session", "log", path("t.tractus") });
    EXPECT_NE(log.out.find("plants a tree of the habit oak, "), std::string::npos) << log.out;
}

TEST_F(BrushCommand, GrowsFromAPlant)
{
    ASSERT_EQ(commands::run({ "grow", "shrub", "-o", path("shrub.mtg") }).exit_code, 0);
    // Runs `tractus brush` on the shrub with further arguments, and returns the number of
    // internodes.
    auto const from = [&](std::vector<std::string> const& more, char const* file) {
        std::vector<std::string> arguments { "brush", "--from", path("shrub.mtg"), "--years", "3" };
        arguments.insert(arguments.end(), more.begin(), more.end());
        arguments.insert(arguments.end(), { "-o", path(file) });
        auto const outcome = commands::run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        auto const end = outcome.out.find(" internodes");
        auto const begin = outcome.out.rfind(' ', end - 1) + 1;
        return end == std::string::npos ? 0 : std::stoi(outcome.out.substr(begin, end - begin));
    };
    EXPECT_GT(from({}, "by_itself.mtg"), 1300) << "hardly anything of 1505 internodes is lost";
    EXPECT_GT(from({ path("up.txt") }, "brushed.mtg"), 1505);
    EXPECT_GT(from({ path("up.txt") }, "t.tractus"), 1505);
    auto const log = commands::run({ "session", "log", path("t.tractus") });
    EXPECT_NE(log.out.find("grow on as it stands by the habit oak"), std::string::npos) << log.out;
    auto const grown = commands::run(
        { "grow", path("shrub.mtg"), "--habit", "oak", "--years", "3", "-o", path("grown.mtg") });
    EXPECT_EQ(grown.exit_code, 0) << grown.err;
    EXPECT_EQ(file_bytes(path("grown.mtg")), file_bytes(path("by_itself.mtg")));
    EXPECT_NE(commands::run(
                  { "grow", path("shrub.mtg"), "--habit", "oak", "--fill", "-o", path("x.mtg") })
                  .err.find("drawn by its outline"),
              std::string::npos);
}

// The recording of a simulated hand that brushes, lets a year pass, prunes, chooses another species
// and clears space must replay.
TEST_F(BrushCommand, ReplaysPruningAndClearing)
{
    std::ofstream(folder_ / "hand.toml") << R"(version = 1
seed = 3
[[gesture]]
tool = "growth_brush"
words = "birch new"
path = "line"
from_mm = [0, 0, 20]
to_mm = [0, 0, 170]
speed_mm_s = 50
[[gesture]]
tool = "growth_brush"
words = "year now"
[[gesture]]
tool = "prune_brush"
words = "radius=12"
path = "line"
from_mm = [-60, 0, 90]
to_mm = [60, 0, 90]
[[gesture]]
tool = "growth_brush"
words = "spruce habit now"
[[gesture]]
tool = "prune_brush"
words = "clear least_radius=30 radius=40"
path = "line"
from_mm = [-30, 0, 170]
to_mm = [30, 0, 170]
)";
    auto const recorded = commands::run(
        { "record", "--simulate", path("hand.toml"), "-o", path("hand.tractus-log") });
    ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
    auto const replayed = [&] {
        terminal::Progress progress;
        batch::DrawingReport report;
        auto drawing = batch::read_drawing(
            { .log = path("hand.tractus-log"), .methods = methods::all_methods() }, scene::Scene {},
            progress, report);
        EXPECT_TRUE(drawing) << (drawing ? "" : drawing.error().message);
        for (auto const& note : report.notes)
            ADD_FAILURE() << note;
        return drawing ? std::move(drawing->scene) : scene::Scene {};
    };
    auto const scene = replayed();
    auto const* const tree = grown_tree_of(scene.drawn->source);
    ASSERT_TRUE(tree);
    using Kind = LifePeriod::Kind;
    std::vector<Kind> kinds;
    for (auto const& part : tree->life)
        kinds.push_back(part.kind);
    EXPECT_EQ(kinds, (std::vector { Kind::Grow, Kind::Grow, Kind::Prune, Kind::Clear }));
    EXPECT_EQ(tree->habit.name, "spruce");
    EXPECT_EQ(replayed().base->node_position_mm, scene.base->node_position_mm);
}

TEST_F(BrushCommand, WritesTheYearsThemselves)
{
    auto const run = [](std::vector<std::string> const& arguments) {
        auto const outcome = commands::run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return outcome.out;
    };
    run({ "grow", "--habit", "birch", "--years", "4", "--sequence", "4", "-o", path("y.mtg") });
    for (int year = 1; year <= 4; ++year) {
        run({ "grow", "--habit", "birch", "--years", std::to_string(year), "-o", path("one.mtg") });
        auto const name = "y-" + std::to_string(year) + ".mtg";
        auto const same_but_for_its_name
            = [&](std::string text) { return text.substr(text.find("CLASSES")); };
        EXPECT_EQ(same_but_for_its_name(file_bytes(path(name.c_str()))),
                  same_but_for_its_name(file_bytes(path("one.mtg"))));
    }
    run({ "grow", "--habit", "birch", "--years", "4", "--animation", "9", "-o", path("y.glb") });
    EXPECT_EQ(file_bytes(path("y.glb")).substr(0, 4), "glTF");
}

TEST_F(BrushCommand, SaysWhatIsMissing)
{
    EXPECT_NE(commands::run({ "brush", path("up.txt") }).err.find("with -o FILE"),
              std::string::npos);
    std::ofstream(folder_ / "empty.txt") << "\n";
    EXPECT_EQ(commands::run({ "brush", path("empty.txt"), "-o", path("x.glb") }).exit_code, 1);
    EXPECT_EQ(
        commands::run({ "brush", path("up.txt"), "--radius", "0", "-o", path("x.glb") }).exit_code,
        2);
    EXPECT_FALSE(fs::exists(path("x.glb")));
}

} // namespace
} // namespace tractus::self_organising
