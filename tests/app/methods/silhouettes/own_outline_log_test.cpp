#include "app/methods/all_methods.h"
#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "tests/app/commands/outcome.h"
#include "tests/app/replayed.h"
#include "tests/app/simulated_drawing.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus::silhouette {
namespace {

using nlohmann::json;

// Returns the text of a gesture for the simulated hand: a closed line around a position, with
// `lobes` lobes.
std::string gesture_around(Vec2 const& middle_mm, double radius_mm, int lobes)
{
    std::string points;
    for (int i = 0; i <= 72; ++i) {
        double const angle = i * kPi / 36 - kPi / 2;
        double const r = radius_mm * (1 + 0.2 * std::fabs(std::sin(0.5 * lobes * angle)));
        points += fmt::format("{}[{:.3f}, {:.3f}, 50]", i > 0 ? ", " : "",
                              middle_mm.x() + r * std::cos(angle),
                              middle_mm.y() + r * std::sin(angle));
    }
    return fmt::format("[[gesture]]\ntool = \"draw\"\npropagation = \"both\"\npath = "
                       "\"polyline\"\npoints_mm = [{}]\n",
                       points);
}

// Returns a recording of a trunk, a crown with four lobes, and an outline of the upper right lobe.
drivers::Log recorded_tree()
{
    std::string hand = "version = 1\nseed = 8\n[[gesture]]\ntool = \"draw\"\npropagation = "
                       "\"both\"\npath = \"line\"\nfrom_mm = [0, -60, 50]\nto_mm = [0, 20, 50]\n";
    hand += gesture_around({ 0, 10 }, 30, 4) + gesture_around({ 19, 29 }, 11, 5);
    auto log = recorded_log(hand);
    for (auto& tool : log.tools) {
        tool.tool = "outline";
        tool.arguments = "";
    }
    return log;
}

json points_of(Stroke const& stroke)
{
    json points;
    for (auto const& tip : stroke.tips)
        points.push_back({ tip.position_mm.x(), tip.position_mm.y() });
    return points;
}

// Returns the report of `tractus silhouette` on a file of the strokes, with the option --branches 0
// as in older logs.
json reported(std::vector<document::DrawnStroke> const& strokes)
{
    auto const file = std::filesystem::temp_directory_path()
        / fmt::format("tractus_own_outline_{}.json", ::getpid());
    std::ofstream(file) << json { { "trunk", points_of(strokes[0].stroke) },
                                  { "outline", points_of(strokes[1].stroke) },
                                  { "parts", { points_of(strokes[2].stroke) } } };
    auto const outcome
        = commands::run({ "silhouette", file.string(), "--branches", "0", "--report" });
    std::filesystem::remove(file);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
}

// Returns a recording of gestures in which the tool has the given words for each gesture.
drivers::Log recorded_lines(std::string const& gestures, std::vector<std::string> const& words)
{
    auto log
        = recorded_log("version = 1\nseed = 8\n[[gesture]]\ntool = \"draw\"\npropagation = "
                       "\"both\"\npath = \"line\"\nfrom_mm = [0, -60, 50]\nto_mm = [0, 20, 50]\n"
                       + gesture_around({ 0, 10 }, 30, 4) + gestures);
    EXPECT_EQ(log.tools.size(), words.size());
    for (std::size_t i = 0; i < log.tools.size(); ++i) {
        log.tools[i].tool = "outline";
        log.tools[i].arguments = words[std::min(i, words.size() - 1)];
    }
    return log;
}

std::string touch_at(double x_mm, double y_mm)
{
    return fmt::format("[[gesture]]\ntool = \"draw\"\npropagation = \"both\"\npath = \"line\"\n"
                       "from_mm = [{0}, {1}, 50]\nto_mm = [{2}, {1}, 50]\n",
                       x_mm, y_mm, x_mm + 1);
}

// Returns the scene after the same strokes are drawn without a log.
scene::Scene drawn_alone(std::vector<document::DrawnStroke> const& strokes,
                         std::vector<OutlineTool> const& tools)
{
    scene::Scene scene;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        auto const edits = tools::Tool(tools[i]).edits_for(strokes[i].stroke, scene);
        EXPECT_TRUE(edits) << edits.error().message;
        if (edits)
            scene = scene::apply_edits(scene, *edits).value();
    }
    return scene;
}

// A bump is split, two bumps are joined, and a leaf is outlined and reverted. The replay must give
// the same tree as drawing directly.
TEST(OwnOutlineLog, GivesTheTreeOfItsTouches)
{
    auto const log = recorded_lines(touch_at(22, 32) + touch_at(-30, 10)
                                        + gesture_around({ 20, -10 }, 11, 5) + touch_at(20, -10),
                                    { "", "", "split", "join", "leaf siblings", "leaf" });
    auto const replay = replayed(log, {}, scene::Scene {});
    ASSERT_EQ(replay.strokes.size(), 6U);
    for (auto const& drawn : replay.strokes)
        EXPECT_EQ(drawn.refusal, "");
    auto const* const tree = silhouette::outlined_tree(*replay.scene.drawn);
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->touches.size(), 2U);
    ASSERT_EQ(tree->own_outlines.size(), 1U);
    EXPECT_FALSE(tree->own_outlines[0].is_leaf);
    using What = OutlineTool::What;
    auto const tool = [](What what, silhouette::StyleScope style = silhouette::StyleScope::None) {
        return OutlineTool { .what = what,
                             .branches = OutlineTool::Branches::OfTrunk,
                             .style = style,
                             .fills = FillsOption::AsAtFirst };
    };
    auto const alone
        = drawn_alone(replay.strokes,
                      { tool(What::GoOn), tool(What::GoOn), tool(What::Split), tool(What::Join),
                        tool(What::Leaf, silhouette::StyleScope::Siblings), tool(What::Leaf) });
    EXPECT_EQ(alone.base->node_position_mm, replay.scene.base->node_position_mm);
    EXPECT_EQ(replayed(log, {}, scene::Scene {}).scene.base->node_position_mm,
              replay.scene.base->node_position_mm);
}

// A tree's lines must give one and the same tree, whether recorded, replayed or read from a file.
TEST(OwnOutlineLog, GivesTheTreeOfItsLines)
{
    auto const log = recorded_tree();
    auto const replay = replayed(log, {}, scene::Scene {});
    ASSERT_EQ(replay.strokes.size(), 3U);
    for (auto const& drawn : replay.strokes)
        EXPECT_EQ(drawn.refusal, "");
    auto const* const tree = silhouette::outlined_tree(*replay.scene.drawn);
    ASSERT_TRUE(tree);
    ASSERT_EQ(tree->own_outlines.size(), 1U);
    auto const skeleton = silhouette::skeleton_of(*tree).value();
    auto const& branches = skeleton.systems[0].branches;
    auto const report = reported(replay.strokes);
    int outlined = 0;
    for (std::size_t i = 0; i < report["branch"].size(); ++i) {
        auto const& given = report["branch"][i];
        EXPECT_NEAR(given["end"][0].get<double>(), branches[i].path.curve.end.x(), 1e-6);
        EXPECT_NEAR(given["end"][1].get<double>(), branches[i].path.curve.end.y(), 1e-6);
        EXPECT_EQ(given.contains("outlined"), branches[i].is_outlined());
        if (!branches[i].is_outlined())
            continue;
        ++outlined;
        EXPECT_EQ(given["bears"], skeleton.branches_on({ 0, i }));
        EXPECT_GE(skeleton.branches_on({ 0, i }), 5U);
    }
    EXPECT_EQ(outlined, 1);
    EXPECT_EQ(replayed(log, {}, scene::Scene {}).scene.base->node_position_mm,
              replay.scene.base->node_position_mm);
}

} // namespace
} // namespace tractus::silhouette
