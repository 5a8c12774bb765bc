#include "app/batch/session_plant.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

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
