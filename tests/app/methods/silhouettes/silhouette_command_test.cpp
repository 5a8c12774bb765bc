#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "tests/app/commands/outcome.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <unistd.h>

namespace tractus::silhouette {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SilhouetteCommand : public ::testing::Test {
protected:
    SilhouetteCommand()
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "oak.json") << crown();
    }
    ~SilhouetteCommand() override { fs::remove_all(folder_); }

    std::string path(std::string const& name) const { return (folder_ / name).string(); }

    // A round crown with five lobes above.
    static json crown()
    {
        json drawing { { "trunk", { { 0, -90 }, { 0, 50 } } } };
        for (int i = 0; i < 240; ++i) {
            double const angle = i * 2 * 3.14159265358979 / 240;
            double const r = 70 + 14 * std::fabs(std::cos(2.5 * (angle - 1.5708)));
            drawing["outline"].push_back({ r * std::cos(angle), r * std::sin(angle) });
        }
        return drawing;
    }

    // Once around its lobe at the right above.
    static json part()
    {
        json stroke;
        for (int i = 0; i < 80; ++i) {
            double const angle = i * 2 * 3.14159265358979 / 80;
            double const r = 24 + 4 * std::cos(5 * angle);
            stroke.push_back({ 57 + r * std::cos(angle), 19 + r * std::sin(angle) });
        }
        return stroke;
    }

    std::string refusal(std::vector<std::string> const& arguments)
    {
        auto const outcome = commands::run(arguments);
        EXPECT_NE(outcome.exit_code, 0);
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    }

    fs::path folder_
        = fs::temp_directory_path() / ("tractus_silhouette_command." + std::to_string(getpid()));
};

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
    ASSERT_EQ(report["arrangement"].size(), 2U);
    for (auto const& place : report["arrangement"][0]) {
        EXPECT_GE(place["theta"], 0);
        EXPECT_LT(place["theta"], 360);
    }
    EXPECT_GT(report["elements"], 1'000);
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

// Wherever it stands among the options, they change it.
TEST_F(SilhouetteCommand, AReadyFormIsItsOptions)
{
    auto const written = [&](std::vector<std::string> arguments) {
        auto const file = path("tree.glb");
        arguments.insert(arguments.begin(),
                         { "silhouette", path("oak.json"), "-o", file, "--organs", "instanced" });
        auto const outcome = commands::run(arguments);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return file_bytes(file);
    };
    auto const fir = written({ "--form", "fir" });
    EXPECT_TRUE(fir
                == written({ "--levels", "1", "--arrangement", "spiral,two-rows", "--density",
                             "1.5", "--leaves", "120", "--leaf-width", "0.25" }));
    auto const bare = written({ "--leaves", "2", "--form", "fir" });
    EXPECT_TRUE(bare != fir);
    EXPECT_TRUE(bare == written({ "--form", "fir", "--leaves", "2" }));
}

// Level by level within 10 % of what the plant has, and so is the report.
TEST_F(SilhouetteCommand, TakesTheStyleOfAPlant)
{
    auto low = crown();
    low["trunk"] = { { 0, -69 }, { 0, 50 } };
    std::ofstream(folder_ / "low.json") << low;
    auto const outcome = commands::run(
        { "silhouette", path("low.json"), "--style", "poplar", "--seed", "3", "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const style = json::parse(outcome.out)["style"];
    ASSERT_EQ(style["measured"].size(), 3U);
    ASSERT_GE(style["tree"].size(), 1U);
    auto const& wanted = style["measured"][0];
    auto const& given = style["tree"][0];
    EXPECT_EQ(wanted["pattern"], "spiral");
    for (auto const* const key : { "children", "spacing", "angle_deg" }) {
        auto const mean = wanted[key]["mean"].get<double>();
        EXPECT_NEAR(given[key]["mean"].get<double>(), mean, 0.1 * mean) << key;
    }
    auto const flat = commands::run({ "silhouette", path("oak.json"), "--style", "poplar",
                                      "--arrangement", "horizontal", "--levels", "1", "--report" });
    auto const report = json::parse(flat.out);
    for (auto const& place : report["arrangement"][0])
        EXPECT_TRUE(place["theta"] == 0 || place["theta"] == 180) << place;
}

TEST_F(SilhouetteCommand, TakesTheStyleOfAFile)
{
    ASSERT_EQ(
        commands::run({ "silhouette", path("oak.json"), "-o", path("out"), "--session" }).exit_code,
        0);
    ASSERT_EQ(commands::run({ "silhouette", path("oak.json"), "-o", path("oak.mtg") }).exit_code,
              0);
    for (std::string const name : { "out/oak.tractus", "oak.mtg" }) {
        auto const again = "again-" + name.substr(name.size() - 3);
        auto const outcome = commands::run({ "silhouette", path("oak.json"), "--style", path(name),
                                             "-o", path(again), "--session", "--report" });
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        auto const style = json::parse(outcome.out)["style"];
        EXPECT_EQ(style["measured"].size(), 2U);
        // The session's tree is in the style, too.
        auto const scene
            = batch::load_session_scene(path(again + "/oak.tractus"), methods::all_methods().edits)
                  .value();
        ASSERT_TRUE(batch::write_plant_file(*scene.base, "oak", path("again.glb")));
        EXPECT_TRUE(file_bytes(path(again + "/oak.glb")) == file_bytes(path("again.glb"))) << name;
    }
}

// As it was before there were styles.
TEST_F(SilhouetteCommand, AFormWithoutStylesIsWrittenWithoutThem)
{
    using silhouette::FormTree;
    FormTree edit { .plant = 7, .form = {} };
    EXPECT_EQ(session::record_of(edit).fields,
              R"({"plant":7,"levels":2,"trunk_pattern":"even","branch_pattern":"even",)"
              R"("twig_pattern":"even","density":1.0,"leaves":24,"leaf_width":0.4,"seed":1})");
    edit.form.styles[1] = { .children = 4, .unbranched = 0.25, .first_angle_deg = 50 };
    auto const again = session::edit_of(session::record_of(edit), methods::all_methods().edits);
    ASSERT_TRUE(again) << again.error().message;
    ASSERT_TRUE(again->get<FormTree>());
    EXPECT_EQ(again->get<FormTree>()->form, edit.form);
}

// Three at a node is what forms say that say nothing, as those from before there were others.
TEST_F(SilhouetteCommand, AFormSaysWhorlsThatAreNotOfThree)
{
    using silhouette::FormTree;
    FormTree edit { .plant = 7, .form = {} };
    edit.form.patterns[1] = Pattern::Whorls;
    auto const written = [&] { return session::record_of(edit).fields; };
    EXPECT_EQ(written().find("whorl\""), std::string::npos) << written();
    edit.form.patterns[1] = Pattern::whorls_of(5);
    EXPECT_NE(written().find(R"("branch_whorl":5)"), std::string::npos) << written();
    auto const again = session::edit_of(session::record_of(edit), methods::all_methods().edits);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->get<FormTree>()->form, edit.form);
}

// Trees whose sessions do not say it keep their nodes as they were.
TEST_F(SilhouetteCommand, AFormSaysThatNodesAreWhole)
{
    using silhouette::FormTree;
    FormTree edit { .plant = 7, .form = {} };
    auto const written = [&] { return session::record_of(edit).fields; };
    EXPECT_EQ(written().find("whole_nodes"), std::string::npos) << written();
    edit.form.has_whole_nodes = true;
    EXPECT_NE(written().find(R"("whole_nodes":true)"), std::string::npos) << written();
    auto const again = session::edit_of(session::record_of(edit), methods::all_methods().edits);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->get<FormTree>()->form, edit.form);
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
    EXPECT_EQ(nodes.size(), 4U); // Of five each.
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

// The tree of the session is the command's: as if a pen had drawn the file's lines.
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

// A hand has stopped 4 mm below the crown: as a pen's, the trunk is the crown's. The outline may be
// of two strokes.
TEST_F(SilhouetteCommand, TakesATrunkThatEndsJustBelowItsCrown)
{
    auto drawing = crown();
    constexpr double kLow = -70; // Where the crown begins above the trunk.
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

TEST_F(SilhouetteCommand, ReportsBranchesWithOutlinesOfTheirOwn)
{
    auto drawing = crown();
    drawing["parts"] = json::array({ part() });
    std::ofstream(folder_ / "part.json") << drawing;
    auto const outcome = commands::run({ "silhouette", path("part.json"), "--report" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    int outlined = 0;
    auto const report = json::parse(outcome.out);
    for (auto const& branch : report["branch"]) {
        outlined += branch.contains("outlined");
        if (branch.contains("outlined")) {
            EXPECT_EQ(branch["outlined"], true);
            EXPECT_GE(branch["bears"], 5);
            EXPECT_GT(branch["end"][0], 30) << "it is the one at the right";
        }
    }
    EXPECT_EQ(outlined, 1);
}

// A part that does not come back is a branch on a branch; the style of its parent goes to siblings.
TEST_F(SilhouetteCommand, DrawsBranchesOnBranches)
{
    std::ofstream(folder_ / "plain.json") << crown();
    auto const plain
        = json::parse(commands::run({ "silhouette", path("plain.json"), "--report" }).out);
    auto const& parent = plain["branch"][0];
    auto const number = [&](char const* of, std::size_t i) { return parent[of][i].get<double>(); };
    double const from_x = 0.4 * number("base", 0) + 0.6 * number("end", 0);
    double const from_y = 0.4 * number("base", 1) + 0.6 * number("end", 1);
    auto drawing = crown();
    json const line = { { from_x, from_y }, { from_x, from_y + 7 }, { from_x + 2, from_y + 14 } };
    drawing["parts"] = json::array({ line });
    std::ofstream(folder_ / "twig.json") << drawing;
    auto const reported = [&](std::vector<std::string> more) {
        more.insert(more.begin(), { "silhouette", path("twig.json"), "--report" });
        auto const outcome = commands::run(more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out);
    };
    auto const count = [](json const& report, char const* key) {
        return std::count_if(report["branch"].begin(), report["branch"].end(),
                             [&](json const& branch) { return branch.contains(key); });
    };
    auto const none = reported({});
    EXPECT_EQ(count(none, "bearing"), 1);
    EXPECT_EQ(count(none, "follows"), 0);
    for (auto const& branch : none["branch"]) {
        if (!branch.contains("bearing"))
            continue;
        ASSERT_EQ(branch["bearing"]["drawn"].size(), 1u);
        EXPECT_NEAR(branch["bearing"]["drawn"][0]["end"][0].get<double>(), from_x + 2, 1e-9);
    }
    EXPECT_EQ(reported({ "--style-to", "none" }), none);
    EXPECT_GE(count(reported({ "--style-to", "siblings" }), "follows"), 5);
    auto const written = commands::run({ "silhouette", path("twig.json"), "-o", path("out"),
                                         "--session", "--style-to", "siblings" });
    ASSERT_EQ(written.exit_code, 0) << written.err;
    auto const scene
        = batch::load_session_scene(path("out/twig.tractus"), methods::all_methods().edits).value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "twig", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/twig.glb")) == file_bytes(path("again.glb"))) << "as by a pen";
}

// A line on a branch in a part is of a deeper level, with the pen as in a file.
TEST_F(SilhouetteCommand, DrawsOnBranchesOfParts)
{
    auto drawing = crown();
    drawing["parts"] = json::array({ part() });
    std::ofstream(folder_ / "part.json") << drawing;
    auto const plain
        = json::parse(commands::run({ "silhouette", path("part.json"), "--report" }).out);
    EXPECT_FALSE(plain.contains("refined"));
    // From the end of the branch in the part's lobe above.
    json const twig = { { 62, 34 }, { 58, 36 }, { 56, 40 } };
    drawing["parts"].push_back(twig);
    std::ofstream(folder_ / "deep.json") << drawing;
    auto const outcome = commands::run({ "silhouette", path("deep.json"), "--report", "-o",
                                         path("out"), "--session", "--style-to", "deeper" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = json::parse(outcome.out);
    ASSERT_EQ(report["refined"].size(), 1u);
    auto const& refined = report["refined"][0];
    EXPECT_NE(refined["path"].get<std::string>().find('/'), std::string::npos);
    ASSERT_EQ(refined["bearing"]["drawn"].size(), 1u);
    EXPECT_NEAR(refined["bearing"]["drawn"][0]["end"][0].get<double>(), 56, 1e-9);
    auto const scene
        = batch::load_session_scene(path("out/deep.tractus"), methods::all_methods().edits).value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "deep", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/deep.glb")) == file_bytes(path("again.glb"))) << "as by a pen";
}

// From the branch with an outline of its own over the next ones: those follow it, as by a pen.
TEST_F(SilhouetteCommand, CarriesAStyleToTheChosen)
{
    auto drawing = crown();
    drawing["parts"] = json::array({ part() });
    std::ofstream(folder_ / "plain.json") << drawing;
    auto const plain
        = json::parse(commands::run({ "silhouette", path("plain.json"), "--report" }).out);
    auto const source
        = std::find_if(plain["branch"].begin(), plain["branch"].end(),
                       [](json const& branch) { return branch.contains("outlined"); });
    ASSERT_NE(source, plain["branch"].end());
    auto const place = [&](json const& branch, double share, std::size_t axis) {
        return (1 - share) * branch["base"][axis].get<double>()
            + share * branch["end"][axis].get<double>();
    };
    auto const& target = plain["branch"][source == plain["branch"].begin() ? 1 : 0];
    drawing["styles"] = json::array(
        { json::array({ source->at("end"), { place(target, 0.9, 0), place(target, 0.9, 1) } }) });
    std::ofstream(folder_ / "styled.json") << drawing;
    auto const outcome = commands::run(
        { "silhouette", path("styled.json"), "--report", "-o", path("out"), "--session" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = json::parse(outcome.out);
    std::size_t styled = 0;
    for (auto const& branch : report["branch"]) {
        if (!branch.contains("style_from"))
            continue;
        ++styled;
        EXPECT_EQ(branch["style_from"], source->at("name"));
        EXPECT_TRUE(branch.contains("bearing"));
    }
    EXPECT_GE(styled, 1u);
    EXPECT_LT(styled, report["branch"].size() - 1);
    auto const scene
        = batch::load_session_scene(path("out/styled.tractus"), methods::all_methods().edits)
              .value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "styled", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/styled.glb")) == file_bytes(path("again.glb")))
        << "as by a pen";
    drawing["styles"] = json::array({ json::array({ { 900, 900 }, { 901, 900 } }) });
    std::ofstream(folder_ / "beside.json") << drawing;
    EXPECT_NE(refusal({ "silhouette", path("beside.json"), "--report" })
                  .find("beside.json: style 1: the line begins on none of the tree's branches"),
              std::string::npos);
}

// On the crown's lobe at the right above, between the two next to it, in the part; with the pen as
// in a file.
TEST_F(SilhouetteCommand, SplitsAndJoinsBumps)
{
    auto const reported = [&](json const& drawing, std::vector<std::string> more = {}) {
        std::ofstream(folder_ / "touched.json") << drawing;
        more.insert(more.begin(), { "silhouette", path("touched.json"), "--report" });
        auto const outcome = commands::run(more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return json::parse(outcome.out);
    };
    auto drawing = crown();
    auto const bumps = reported(drawing)["bumps"].get<int>();
    drawing["splits"] = { { 70, 22 } };
    auto const split = reported(drawing);
    EXPECT_EQ(split["bumps"], bumps + 1);
    drawing.erase("splits");
    drawing["joins"] = { { -41, 57 } };
    EXPECT_EQ(reported(drawing)["bumps"], bumps - 1);
    drawing["splits"] = { { 63.5, 39 }, { 78, 19 } };
    drawing["parts"] = json::array({ part() });
    auto const all = reported(drawing, { "-o", path("out"), "--session" });
    EXPECT_EQ(all["bumps"], bumps - 1) << "both splits are in the part";
    auto const scene
        = batch::load_session_scene(path("out/touched.tractus"), methods::all_methods().edits)
              .value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "touched", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/touched.glb")) == file_bytes(path("again.glb")))
        << "as by a pen";
    auto const touches = silhouette::outlined_tree(*scene.drawn)->touches;
    ASSERT_EQ(touches.size(), 3u);
    EXPECT_EQ(touches[0].branch, "");
    EXPECT_NE(touches[1].branch, "");
}

TEST_F(SilhouetteCommand, DrawsLeaves)
{
    auto drawing = crown();
    drawing["leaves"] = json::array({ part() });
    std::ofstream(folder_ / "leafy.json") << drawing;
    auto const outcome = commands::run({ "silhouette", path("leafy.json"), "--report", "-o",
                                         path("out"), "--session", "--style-to", "siblings" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = json::parse(outcome.out);
    for (auto const& branch : report["branch"])
        EXPECT_EQ(branch["leaf"], true);
    EXPECT_EQ(report["leaves"], report["branches"]);
    auto const scene
        = batch::load_session_scene(path("out/leafy.tractus"), methods::all_methods().edits)
              .value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "leafy", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/leafy.glb")) == file_bytes(path("again.glb")))
        << "as by a pen";
    auto whole = crown();
    whole["leaves"] = json::array({ whole["outline"] });
    whole.erase("outline");
    std::ofstream(folder_ / "leaf.json") << whole;
    auto const leaf = commands::run(
        { "silhouette", path("leaf.json"), "--report", "-o", path("out"), "--session" });
    ASSERT_EQ(leaf.exit_code, 0) << leaf.err;
    auto const one = json::parse(leaf.out);
    EXPECT_EQ(one["leaf"], true);
    EXPECT_EQ(one["leaves"], 1);
    EXPECT_EQ(one["bumps"], 0);
    auto const again
        = batch::load_session_scene(path("out/leaf.tractus"), methods::all_methods().edits).value();
    EXPECT_EQ(again.base->organs.size(), 1u);
}

// A point where a branch ends makes a leaf of that branch's part of the crown, as a pen's touch.
TEST_F(SilhouetteCommand, MakesALeafOfABump)
{
    auto const plain
        = json::parse(commands::run({ "silhouette", path("oak.json"), "--report" }).out);
    auto const& branch = plain["branch"][0];
    auto drawing = crown();
    drawing["leaves"] = json::array({ json::array({ branch["end"] }) });
    std::ofstream(folder_ / "bump.json") << drawing;
    auto const outcome = commands::run({ "silhouette", path("bump.json"), "--report", "-o",
                                         path("out"), "--session", "--style-to", "siblings" });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    auto const report = json::parse(outcome.out);
    EXPECT_EQ(report["branch"][0]["name"], branch["name"]);
    EXPECT_EQ(report["branch"][0]["outlined"], true);
    for (auto const& one : report["branch"])
        EXPECT_EQ(one["leaf"], true);
    auto const scene
        = batch::load_session_scene(path("out/bump.tractus"), methods::all_methods().edits).value();
    ASSERT_TRUE(batch::write_plant_file(*scene.base, "bump", path("again.glb")));
    EXPECT_TRUE(file_bytes(path("out/bump.glb")) == file_bytes(path("again.glb"))) << "by a pen";
    drawing["leaves"] = { { { 500, 0 } } };
    std::ofstream(folder_ / "bump.json") << drawing;
    EXPECT_NE(refusal({ "silhouette", path("bump.json"), "--report" })
                  .find("leaf 1: [500, 0] is on no bump that a branch ends in"),
              std::string::npos);
}

TEST_F(SilhouetteCommand, SaysWhichTouchIsWrong)
{
    auto drawing = crown();
    drawing["splits"] = { { 0, 0 } };
    std::ofstream(folder_ / "touch.json") << drawing;
    EXPECT_NE(refusal({ "silhouette", path("touch.json"), "--report" })
                  .find("touch.json: split at [0, 0]: the touch is on no bump"),
              std::string::npos);
    drawing.erase("splits");
    drawing["joins"] = { { 0 } };
    std::ofstream(folder_ / "touch.json") << drawing;
    EXPECT_NE(refusal({ "silhouette", path("touch.json"), "--report" })
                  .find("touch.json: point 1 of joins is no point"),
              std::string::npos);
    drawing.erase("joins");
    drawing["leaves"] = json::array({ drawing["outline"] });
    std::ofstream(folder_ / "touch.json") << drawing;
    EXPECT_NE(refusal({ "silhouette", path("touch.json"), "--report" })
                  .find("touch.json: leaf 1: the outline lies around none"),
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
