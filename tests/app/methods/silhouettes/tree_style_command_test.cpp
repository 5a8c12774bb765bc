#include "app/batch/plant_file.h"
#include "app/batch/session_plant.h"
#include "app/methods/all_methods.h"
#include "app/session/edit_record.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "tests/app/methods/silhouettes/silhouette_folder.h"
#include "tests/file_bytes.h"

#include <fstream>

// Tests of the forms and styles that `tractus silhouette` accepts, and of the arrangement of
// branches at nodes.

namespace tractus::silhouette {
namespace {

// A ready-made form must be equivalent to its options. Other options override it in any order.
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
    EXPECT_TRUE(fir == written({ "--levels",     "1",    "--arrangement", "spiral,two-rows",
                                 "--density",    "1.5",  "--leaves",      "120",
                                 "--leaf-width", "0.25", "--branches",    "36",
                                 "--base-angle", "98",   "--tip-angle",   "50",
                                 "--rise",       "0.15", "--bark",        "fir" }));
    auto const bare = written({ "--leaves", "2", "--form", "fir" });
    EXPECT_TRUE(bare != fir);
    EXPECT_TRUE(bare == written({ "--form", "fir", "--leaves", "2" }));
}

// The style of the tree must agree within 10 % with that of the given plant on each level, and so
// must the report.
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
        // The tree in the session must have the style, too.
        auto const scene
            = batch::load_session_scene(path(again + "/oak.tractus"), methods::all_methods().edits)
                  .value();
        ASSERT_TRUE(batch::write_plant_file(*scene.base, "oak", path("again.glb")));
        EXPECT_TRUE(file_bytes(path(again + "/oak.glb")) == file_bytes(path("again.glb"))) << name;
    }
}

// A form without styles must be written as it was before styles existed.
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

// A whorl has three branches by default, also in older forms. The form states only other numbers.
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

// Sessions that lack this setting are older: their trees keep their incomplete nodes.
TEST_F(SilhouetteCommand, AFormSaysThatNodesAreWhole)
{
    using silhouette::FormTree;
    FormTree edit { .plant = 7, .form = {} };
    auto const written = [&] { return session::record_of(edit).fields; };
    EXPECT_EQ(written().find("whole_nodes"), std::string::npos) << written();
    edit.form.has_whole_nodes = true;
    EXPECT_NE(written().find(R"("whole_nodes":true)"), std::string::npos) << written();
    // Sessions without this setting are older, too: leaves do not fill the outlines of their trees.
    EXPECT_EQ(written().find("leaves_reach_outline"), std::string::npos) << written();
    edit.form.leaves_reach_outline = true;
    EXPECT_NE(written().find(R"("leaves_reach_outline":true)"), std::string::npos) << written();
    auto const again = session::edit_of(session::record_of(edit), methods::all_methods().edits);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->get<FormTree>()->form, edit.form);
}

} // namespace
} // namespace tractus::silhouette
