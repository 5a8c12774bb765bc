#include "app/files/resources.h"
#include "app/methods/all_methods.h"
#include "app/session/session_file.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/scene/scene.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus::sketch {
namespace {

namespace fs = std::filesystem;

class SketchCommand : public ::testing::Test {
protected:
    SketchCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "straight.txt") << "10 20 5\n10 20 105\n";
        std::ofstream(folder_ / "rule.toml")
            << "l = 40\nr = 0.8\nw = 4\nq = 0.5\ns = 0.5\nv = 0.5\n";
    }
    ~SketchCommand() override { fs::remove_all(folder_); }

    std::string path(char const* name) const { return (folder_ / name).string(); }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_sketch_command." + std::to_string(getpid()));
};

TEST_F(SketchCommand, ReportsWhatAStrokeAmountsTo)
{
    auto const outcome = commands::run({ "sketch", path("straight.txt"), "--rule",
                                         path("rule.toml"), "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["segments"], 3);
    EXPECT_EQ(report["depth"], 64);
    EXPECT_EQ(report["nodes"].size(), 4U);
    EXPECT_EQ(report["nodes"][1], (std::vector<double> { 10, 20, 45 }));
    EXPECT_EQ(report["bend"], (std::vector<double> { 0, 0, 0 }));
    ASSERT_EQ(report["counts"].size(), 3U);
    EXPECT_EQ(report["counts"][2]["L"], 14);
    EXPECT_EQ(report["counts"][2]["F"], 11);
}

TEST_F(SketchCommand, WritesAModelThatDerivesToThePlantsString)
{
    ASSERT_EQ(commands::run({ "sketch", path("straight.txt"), "--rule", path("rule.toml"), "-o",
                              path("out"), "--report" })
                  .exit_code,
              0);
    auto const derived
        = commands::run({ "derive", "--string", "--steps", "1", path("out/straight.l") });
    EXPECT_EQ(derived.err, "");
    EXPECT_EQ(derived.out,
              "/(0)+(0)\\(0)!(4)F(40)[/(90)+(45)L(20,2,64)][/(270)+(45)L(20,2,64)]T(1,32,2)\n");
}

TEST_F(SketchCommand, SaysWhatIsWrongWithAStroke)
{
    std::ofstream(folder_ / "short.txt") << "0 0 0\n0 0 20\n";
    auto const outcome = commands::run({ "sketch", path("short.txt"), "-o", path("out") });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("the stroke never gets 30 mm away from where it begins"),
              std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    auto const missing
        = commands::run({ "sketch", path("straight.txt"), "--stroke", "2", "-o", path("out") });
    EXPECT_NE(missing.err.find("it has no stroke 2, its last is 1"), std::string::npos)
        << missing.err;
}

class SketchedModel : public SketchCommand {
protected:
    SketchedModel()
    {
        std::ofstream bow(folder_ / "bow.txt");
        for (int i = 0; i < 150; ++i)
            bow << 60 * std::sin(i / 50.0) << ' ' << 12 * std::sin(i / 25.0) << ' ' << 1.3 * i
                << '\n';
        std::ofstream(folder_ / "lacking.l")
            << "#define N 0\nLsystem: 1\nderivation length: 1\nAxiom: F(1)\nendlsystem\n";
    }

    // Returns the example model in the manual: the first code block without a language on the page
    // models.md.
    static std::string model_of_manual()
    {
        std::string const text = file_bytes(files::find_resource("manual/models.md").value());
        auto const begin = text.find("#define SEGMENTS 0");
        return text.substr(begin, text.find("```", begin) - begin);
    }
};

TEST_F(SketchedModel, ReportsItsAxisAndNoDepth)
{
    auto const outcome = commands::run(
        { "sketch", path("bow.txt"), "--rule", "vine", "-o", path("out"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = nlohmann::json::parse(outcome.out);
    std::size_t const segments = report["segments"];
    EXPECT_GT(segments, 40u);
    EXPECT_EQ(report["nodes"].size(), segments + 1);
    EXPECT_EQ(report["plane"].size(), segments);
    EXPECT_EQ(report["bend"].size(), segments);
    EXPECT_FALSE(report.contains("depth"));
    ASSERT_EQ(report["counts"].size(), segments);
    EXPECT_EQ(report["counts"].back()["Z"], segments);
}

// The written model must derive to the same plant, and must also be able to grow along another
// stroke.
TEST_F(SketchedModel, IsWrittenAsAModel)
{
    ASSERT_EQ(
        commands::run({ "sketch", path("bow.txt"), "--rule", "palm", "-o", path("out") }).exit_code,
        0);
    for (auto const* const file : { "out/bow.l", "out/bow.v", "out/bow.png", "out/bow.glb" })
        EXPECT_TRUE(fs::exists(path(file))) << file;
    auto const checked = commands::run({ "lsystem", "check", path("out/bow.l") });
    EXPECT_NE(checked.out.find("\nCan be grown along a stroke\n"), std::string::npos)
        << checked.out << checked.err;
    auto const again = commands::run({ "sketch", path("straight.txt"), "--rule", path("out/bow.l"),
                                       "-o", path("again"), "--report" });
    EXPECT_EQ(nlohmann::json::parse(again.out)["segments"], 15) << "100 mm by 6.5";
}

TEST_F(SketchedModel, BeginsASessionThatHoldsItsText)
{
    auto const text = model_of_manual();
    std::ofstream(folder_ / "whip.l") << text;
    auto const outcome = commands::run({ "sketch", path("bow.txt"), "--rule", path("whip.l"),
                                         "--seed", "7", "--session", "-o", path("out") });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const session
        = session::read_session(path("out/bow.tractus"), methods::all_methods().edits).value();
    ASSERT_EQ(session.edits.size(), 1u);
    auto const* const edit = session.edits.front().edit.get<sketch::GrowAlongStroke>();
    ASSERT_NE(edit, nullptr);
    EXPECT_EQ(edit->model.source.text, text);
    EXPECT_EQ(edit->model.seed, 7u);
    auto const scene = scene::apply_edit(scene::Scene {}, *edit).value();
    EXPECT_EQ(scene.base->organs.size(), sketch::drawn_nodes_mm(*edit).value().size() - 1);
}

TEST_F(SketchedModel, MayBeThatOfACard)
{
    std::ofstream(folder_ / "mine.card") << "# A card.\nsketch vine\n";
    auto const report = [&](std::string const& rule) {
        return commands::run(
            { "sketch", path("bow.txt"), "--rule", rule, "-o", path("out"), "--report" });
    };
    EXPECT_EQ(report(path("mine.card")).out, report("vine").out);
}

TEST_F(SketchedModel, SaysWhatAModelLacks)
{
    auto const checked = commands::run({ "lsystem", "check", path("lacking.l") });
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    auto const begins = checked.out.find("\nCannot be grown along a stroke: ");
    ASSERT_NE(begins, std::string::npos) << checked.out;
    EXPECT_NE(checked.out.find("it has no array plane", begins), std::string::npos);
    auto const refused = commands::run(
        { "sketch", path("bow.txt"), "--rule", path("lacking.l"), "-o", path("out") });
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.err.find("so it cannot grow along a stroke; \"tractus lsystem check\" says "
                               "all that it lacks"),
              std::string::npos)
        << refused.err;
    EXPECT_FALSE(fs::exists(path("out/bow.l")));
}

TEST_F(SketchedModel, CanBeEachOfOursThatTheHelpNames)
{
    for (auto const* const name :
         { "birch", "broadleaf", "conifer", "frond", "palm", "poplar", "vine" }) {
        auto const checked = commands::run({ "lsystem", "check", name });
        EXPECT_NE(checked.out.find("\nCan be grown along a stroke\n"), std::string::npos) << name;
    }
    auto const shrub = commands::run({ "lsystem", "check", "shrub" });
    EXPECT_NE(shrub.out.find("\nCannot be grown along a stroke: "), std::string::npos);
}

} // namespace
} // namespace tractus::sketch
