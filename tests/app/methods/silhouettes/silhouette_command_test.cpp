#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/methods/all_methods.h"
#include "tests/app/methods/silhouettes/silhouette_folder.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <fstream>
#include <set>

namespace tractus::silhouette {
namespace {

TEST_F(SilhouetteCommand, ReportsWhatItInfers)
{
    auto const outcome = commands::run({ "silhouette", path("oak.json"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = json::parse(outcome.out);
    EXPECT_EQ(report["samples"], 256);
    EXPECT_EQ(report["triangles"], 254);
    EXPECT_EQ(report["terminal"].get<int>(), report["junction"].get<int>() + 2);
    EXPECT_EQ(2 * report["terminal"].get<int>() + report["sleeve"].get<int>(), 256);
    EXPECT_EQ(report["bump"].size(), report["bumps"]);
    EXPECT_EQ(report["bumps"], 5);
    for (auto const& bump : report["bump"])
        for (auto const* const key : { "E", "r", "tip", "role" })
            EXPECT_TRUE(bump.contains(key)) << key;
    for (auto const& branch : report["branch"]) {
        EXPECT_EQ(branch["curve"].size(), 4U);
        EXPECT_EQ(branch["curve"][0], branch["base"]);
        EXPECT_EQ(branch["curve"][3], branch["end"]);
    }
    EXPECT_LE(report["coverage"]["before"], report["coverage"]["after"]);
    EXPECT_GE(report["coverage"]["after"], 0.85);
    EXPECT_GE(report["leaf_coverage"]["inside"], 0.92);
    EXPECT_LE(report["leaf_coverage"]["outside"], 0.08);
    ASSERT_EQ(report["arrangement"].size(), 2U);
    for (auto const& place : report["arrangement"][0]) {
        EXPECT_GE(place["theta"], 0);
        EXPECT_LT(place["theta"], 360);
    }
    EXPECT_GT(report["elements"], 1'000);
}

// The paper's own filling, which the manual's figures use, must stay as it was.
TEST_F(SilhouetteCommand, FillsWithLeavesUnlessThePapersFillingIsAskedFor)
{
    auto const inside = [&](std::vector<std::string> const& more) {
        std::vector<std::string> words { "silhouette", path("oak.json"), "--report" };
        words.insert(words.end(), more.begin(), more.end());
        return json::parse(commands::run(words).out)["leaf_coverage"]["inside"].get<double>();
    };
    EXPECT_LT(inside({ "--branches", "0" }), 0.9);
    EXPECT_GE(inside({ "--branches", "20" }), 0.92);
}

TEST_F(SilhouetteCommand, TheSameSeedGivesTheSameFile)
{
    for (auto const& [name, seed] :
         { std::pair("a.glb", "7"), std::pair("b.glb", "7"), std::pair("c.glb", "8") })
        ASSERT_EQ(commands::run({ "silhouette", path("oak.json"), "-o", path(name), "--levels", "1",
                                  "--seed", seed, "--organs", "instanced" })
                      .exit_code,
                  0);
    EXPECT_GT(file_bytes(path("a.glb")).size(), 10'000U);
    EXPECT_TRUE(file_bytes(path("a.glb")) == file_bytes(path("b.glb")));
    EXPECT_FALSE(file_bytes(path("a.glb")) == file_bytes(path("c.glb")));
}

TEST_F(SilhouetteCommand, WritesAGraphThatIsAPlant)
{
    ASSERT_EQ(
        commands::run({ "silhouette", path("oak.json"), "-o", path("oak.mtg"), "--levels", "1" })
            .exit_code,
        0);
    auto const grown = commands::run({ "grow", path("oak.mtg"), "-o", path("again.mtg") });
    ASSERT_EQ(grown.exit_code, 0) << grown.err;
    EXPECT_FALSE(std::filesystem::is_directory(path("oak.mtg")));
}

TEST_F(SilhouetteCommand, PrintsAnArrangementAlone)
{
    auto const outcome
        = commands::run({ "silhouette", "--arrangement", "even", "--count", "30", "--seed", "3" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const arrangement = json::parse(outcome.out);
    EXPECT_EQ(arrangement["pattern"], "even");
    EXPECT_EQ(arrangement["places"].size(), 30U);
    EXPECT_LT(arrangement["cost_after"], arrangement["cost_before"]);
    auto const again
        = commands::run({ "silhouette", "--arrangement", "even", "--count", "30", "--seed", "3" });
    EXPECT_EQ(again.out, outcome.out);
    EXPECT_FALSE(arrangement.contains("whorl"));
}

TEST_F(SilhouetteCommand, WhorlsHaveAsManyBranchesAsAreAskedFor)
{
    auto const fives = json::parse(
        commands::run({ "silhouette", "--arrangement", "whorls", "--whorl", "5", "--count", "20" })
            .out);
    EXPECT_EQ(fives["whorl"], 5);
    std::set<double> nodes;
    for (auto const& place : fives["places"])
        nodes.insert(std::round(1e9 * place["u"].get<double>()));
    EXPECT_EQ(nodes.size(), 4U); // Each of the four nodes has five branches.
    auto const report = [&](std::vector<std::string> options) {
        options.insert(options.begin(), { "silhouette", path("oak.json"), "--report" });
        return json::parse(commands::run(options).out)["arrangement"];
    };
    auto const threes = report({ "--arrangement", "even,whorls" });
    EXPECT_EQ(report({ "--arrangement", "even,whorls", "--whorl", "3" }), threes);
    auto const sevens = report({ "--arrangement", "even,whorls", "--whorl", "7" });
    EXPECT_EQ(sevens[0], threes[0]) << "stand evenly";
    EXPECT_NE(sevens[1], threes[1]);
    EXPECT_NE(report({ "--form", "pine" }), report({ "--form", "pine", "--whorl", "5" }));
    EXPECT_NE(refusal({ "silhouette", path("oak.json"), "--report", "--whorl", "5" })
                  .find("give --arrangement whorls, too"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette", "--arrangement", "whorls", "--count", "9", "--whorl", "13" })
                  .find("--whorl"),
              std::string::npos);
}

TEST_F(SilhouetteCommand, PatternsAreOfLevels)
{
    auto const report = [&](std::string const& patterns) {
        return json::parse(
            commands::run({ "silhouette", path("oak.json"), "--report", "--arrangement", patterns })
                .out);
    };
    auto const flat = report("horizontal,even");
    for (auto const& place : flat["arrangement"][0])
        EXPECT_TRUE(place["theta"] == 0 || place["theta"] == 180) << place;
    EXPECT_NE(report("even")["arrangement"][0], flat["arrangement"][0]);
}

// The tree in the session must be the command's, as if a pen had drawn the lines of the file.
TEST_F(SilhouetteCommand, WritesASessionOfItsLines)
{
    auto drawing = crown();
    drawing["branches"] = json::array({ { { 0, -20 }, { -20, -15 }, { -40, -12 } } });
    drawing["parts"] = json::array({ part() });
    std::ofstream(folder_ / "oak.json") << drawing;
    auto const outcome
        = commands::run({ "silhouette", path("oak.json"), "-o", path("out"), "--session",
                          "--arrangement", "spiral,whorls", "--leaves", "9", "--height", "3" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const scene
        = batch::load_session_scene(path("out/oak.tractus"), methods::all_methods().edits).value();
    EXPECT_NEAR(bounds(*scene.base).max_mm.z(), 3000, 400);
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "oak", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/oak.glb")) == file_bytes(path("again.glb")));
    auto const flat
        = commands::run({ "silhouette", path("oak.json"), "-o", path("x.glb"), "--session" });
    EXPECT_NE(flat.err.find("a session needs a folder"), std::string::npos);
}

// The trunk ends 4 mm below the crown. It must belong to the crown nevertheless, as when drawn by
// pen. The outline may consist of two strokes.
TEST_F(SilhouetteCommand, TakesATrunkThatEndsJustBelowItsCrown)
{
    auto drawing = crown();
    constexpr double kLow = -70; // The crown's lowest point above the trunk.
    auto const trunk_to = [&](double top) {
        drawing["trunk"] = { { 0, top - 60 }, { 1, top - 30 }, { 0, top } };
        std::ofstream(folder_ / "below.json") << drawing;
    };
    trunk_to(kLow - 4);
    auto const outcome
        = commands::run({ "silhouette", path("below.json"), "-o", path("out"), "--session" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("below.json: the trunk ends just below the crown"),
              std::string::npos);
    auto const scene
        = batch::load_session_scene(path("out/below.tractus"), methods::all_methods().edits)
              .value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "below", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/below.glb")) == file_bytes(path("again.glb")));
    auto const& outline = drawing["outline"];
    auto const middle = outline.begin() + 120;
    drawing["outline"]
        = json::array({ json(outline.begin(), middle + 1), json(middle, outline.end()) });
    trunk_to(kLow - 4);
    EXPECT_EQ(commands::run({ "silhouette", path("below.json"), "--report" }).exit_code, 0);
    trunk_to(kLow - 10);
    EXPECT_NE(refusal({ "silhouette", path("below.json"), "--report" })
                  .find("below.json: the trunk is wholly outside of the outline"),
              std::string::npos);
}

TEST_F(SilhouetteCommand, SaysWhatIsWrong)
{
    auto large = crown();
    large["parts"] = { part(), large["outline"] };
    std::ofstream(folder_ / "large.json") << large;
    EXPECT_NE(refusal({ "silhouette", path("large.json"), "--report" })
                  .find("large.json: part 2: the outline lies around none of the tree's branches"),
              std::string::npos);
    std::ofstream(folder_ / "open.json")
        << R"({"outline":[[0,0],[10,0],[20,0],[30,2],[40,9],[44,20],[40,30],[30,38],[20,40]]})";
    EXPECT_NE(refusal({ "silhouette", path("open.json"), "--report" })
                  .find("open.json: the outline is open: end it near its beginning"),
              std::string::npos);
    auto outside = crown();
    outside["trunk"] = { { 200, 0 }, { 200, 50 } };
    std::ofstream(folder_ / "outside.json") << outside;
    EXPECT_NE(refusal({ "silhouette", path("outside.json"), "--report" })
                  .find("outside.json: the trunk is wholly outside of the outline"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette", path("oak.json") }).find("nothing is asked for"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette" }).find("there is no drawing"), std::string::npos);
    EXPECT_NE(refusal({ "silhouette", path("oak.json"), "--report", "--style", "leaf.none" })
                  .find("leaf.none"),
              std::string::npos);
    std::ofstream(folder_ / "pole.l")
        << "Lsystem: 1\nderivation length: 0\nAxiom: F(9)\nendlsystem\n";
    EXPECT_NE(refusal({ "silhouette", path("oak.json"), "--report", "--style", path("pole.l") })
                  .find("the plant has no branches"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette", path("oak.json"), "--report", "--style", "poplar", "--form",
                        "oak" })
                  .find("--form"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette", path("oak.json"), path("oak.json"), "-o", path("a.glb") })
                  .find("several trees need a folder"),
              std::string::npos);
    EXPECT_NE(refusal({ "silhouette", path("none.json"), "--report" }).find("none.json"),
              std::string::npos);
}

TEST_F(SilhouetteCommand, SaysWhatItHadToGuess)
{
    auto drawing = crown();
    drawing.erase("trunk");
    drawing["colour"] = "green";
    std::ofstream(folder_ / "bare.json") << drawing;
    auto const outcome = commands::run({ "silhouette", path("bare.json"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("\"colour\" is left out"), std::string::npos);
    EXPECT_NE(outcome.err.find("there is no trunk"), std::string::npos);
    EXPECT_EQ(json::parse(outcome.out)["notes"].size(), 1U);
}

TEST(SilhouetteCommandCorpus, ReportsTheBumpsOfThePublishedOutlines)
{
    REQUIRE_CORPUS();
    int files = 0;
    for (auto const& entry : fs::directory_iterator(corpus() / "silhouettes")) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "arrangement")
            continue;
        ++files;
        auto const outcome = commands::run({ "silhouette", entry.path().string(), "--report" });
        ASSERT_EQ(outcome.exit_code, 0) << entry.path() << outcome.err;
        auto const report = json::parse(outcome.out);
        std::ifstream stream(entry.path());
        auto const expected = json::parse(stream)["expected"];
        for (auto const* const key : { "samples", "triangles", "bumps", "trunk_samples_inside" })
            EXPECT_EQ(report[key], expected[key]) << entry.path() << key;
        EXPECT_LE(report["branch"].size(), 60U);
    }
    EXPECT_EQ(files, 11);
}

} // namespace
} // namespace tractus::silhouette
