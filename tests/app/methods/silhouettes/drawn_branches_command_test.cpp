#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/methods/all_methods.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "tests/app/methods/silhouettes/silhouette_folder.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <fstream>

// Tests of what can be drawn on an inferred tree: branches, styles, touches and leaves.

namespace tractus::silhouette {
namespace {

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

// An open line in "parts" is a branch of a branch. If asked to, the siblings of the latter take its
// style.
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

// A line on a branch of a part must be drawn on a deeper level of the tree, whether it is drawn by
// pen or read from a file.
TEST_F(SilhouetteCommand, DrawsOnBranchesOfParts)
{
    auto drawing = crown();
    drawing["parts"] = json::array({ part() });
    std::ofstream(folder_ / "part.json") << drawing;
    auto const plain
        = json::parse(commands::run({ "silhouette", path("part.json"), "--report" }).out);
    EXPECT_FALSE(plain.contains("refined"));
    // This line begins at the end of the branch in the upper lobe of the part.
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

// A line in the file may lead from a branch that has its own outline across other branches. These
// must then take the style of that branch, as with a line drawn by pen.
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

// The file contains touches: on the crown's upper right lobe, between the two lobes next to it, and
// in the part. They must have the same effect as touches by pen.
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

// A point at the end of a branch must make a leaf of that branch's part of the crown, as a touch of
// the pen does.
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

} // namespace
} // namespace tractus::silhouette
