#include "app/methods/leaves/leaf_line_tool.h"

#include "app/controllers/drawn_leaf_files.h"
#include "app/methods/all_leaves.h"
#include "app/methods/all_methods.h"
#include "app/methods/leaves/erase_leaf_tool.h"
#include "app/methods/leaves/leaf_layers.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "tests/app/our_plant.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;

// Returns a closed spindle-shaped outline of a leaf, 80 mm long, that begins at the leaf's base.
Stroke leaf_outline(double x_mm = 0)
{
    std::vector<Vec3> places;
    for (int i = 0; i <= 80; ++i) {
        double const t = i <= 40 ? i / 40.0 : (80 - i) / 40.0;
        double const side = i <= 40 ? 1 : -1;
        places.emplace_back(x_mm + side * 20 * std::sin(t * kPi), -40 + 80 * t, 120);
    }
    return stroke_through(places);
}

Stroke midrib(double x_mm = 0)
{
    return stroke_through({ { x_mm, -60, 120 }, { x_mm, 0, 120 }, { x_mm, 39, 120 } });
}

Stroke vein(int number, double side)
{
    double const y = -20 + 15 * number;
    return stroke_through({ { 0, y, 120 }, { side * 12, y + 11, 120 } });
}

scene::Scene after(scene::Scene const& scene, tools::Tool const& tool, Stroke const& stroke)
{
    auto const edits = tool.kind().edits_for(tool, stroke, scene);
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::apply_edits(scene, *edits).value() : scene;
}

scene::Scene drawn_leaf(LeafLineTool const& tool = {})
{
    auto scene = after(after({}, tool, leaf_outline()), LeafLineTool {}, midrib());
    for (int number = 0; number < 3; ++number)
        for (double const side : { -1.0, 1.0 })
            scene = after(scene, LeafLineTool {}, vein(number, side));
    return scene;
}

leaf::LeafSketch const& sketch_in(scene::Scene const& scene)
{
    return *leaf::active_leaf_sketch(scene.state);
}

TEST(LeafLineTool, SaysItsNumbersInLogs)
{
    LeafLineTool const tool { .plant = LeafLineTool::Plant::NewLeaf, .bend_deg = 20, .teeth = 8 };
    auto const words = tools::words_for(tool);
    EXPECT_EQ(words.name + " " + words.arguments, "leaf_line new_leaf bend=20 teeth=8 compound");
    EXPECT_EQ(tools::parse_tool(methods::all_methods().tools, words.name, words.arguments).value(),
              tools::Tool(tool));
}

TEST(LeafLineTool, DrawsALeafLineByLine)
{
    auto const scene = drawn_leaf({ .bend_deg = 30 });
    ASSERT_EQ(scene.plants.size(), 1u);
    auto const& sketch = sketch_in(scene);
    EXPECT_EQ(sketch.lines.size(), 8u);
    EXPECT_EQ(sketch.form.bend_deg, 30) << "of the leaf that began";
    EXPECT_EQ(LeafLineTool::kKind.describe(LeafLineTool {}, scene),
              "A leaf of 80 mm with 6 side veins");
    EXPECT_EQ(kLeafOutlineLayer.lines(*scene.plants.front()).size(), 1u);
    auto const another
        = after(scene, LeafLineTool { .plant = LeafLineTool::Plant::NewLeaf }, leaf_outline(90));
    EXPECT_EQ(another.plants.size(), 2u);
    EXPECT_EQ(sketch_in(another).lines.size(), 1u);
}

TEST(LeafLineTool, LetsTheLeafFollowItsNumbers)
{
    auto const scene = drawn_leaf({ .teeth = 9 });
    tools::Tool const before = LeafLineTool {};
    tools::Tool const after_it = LeafLineTool { .bend_deg = 45 };
    auto const edits = LeafLineTool::kKind.follow(before, after_it, scene);
    ASSERT_EQ(edits.size(), 1u);
    auto const& form = edits[0].get<leaf::FormLeaf>()->form;
    EXPECT_EQ(form.bend_deg, 45);
    EXPECT_EQ(form.teeth, 9) << "what the hand has not changed stays";
    EXPECT_TRUE(LeafLineTool::kKind.follow(before, before, scene).empty());
    auto const like = LeafLineTool::kKind.like_drawn(before, scene);
    ASSERT_TRUE(like);
    EXPECT_EQ(like->get<LeafLineTool>()->teeth, 9);
    EXPECT_FALSE(LeafLineTool::kKind.like_drawn(before, our_plant("shrub")));
}

TEST(EraseLeafTool, TakesLinesAwayThatItTouches)
{
    auto const scene = drawn_leaf();
    auto const erased
        = after(scene, EraseLeafTool {}, stroke_through({ { 9, 4, 120 }, { 11, 6, 120 } }));
    EXPECT_EQ(sketch_in(erased).lines.size(), 7u);
    tools::Tool const tool = EraseLeafTool {};
    auto const beside
        = tool.kind().edits_for(tool, stroke_through({ { 90, 4, 120 }, { 91, 6, 120 } }), scene);
    ASSERT_FALSE(beside);
    EXPECT_EQ(beside.error().message,
              "the eraser touched nothing of the leaf: move it over a line of its drawing");
}

// A leaf drawn by pen is kept in a file, and a tree can wear it, as in the window.
TEST(DrawnLeaves, AreKeptAndWorn)
{
    auto const folder = fs::temp_directory_path() / fmt::format("tractus_drawn_{}", ::getpid());
    auto const scene = drawn_leaf();
    auto const files = controllers::write_drawn_leaves(scene.state, folder / "cache");
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(controllers::write_drawn_leaves(scene.state, folder / "cache"), files);
    auto const kept = controllers::keep_leaf(files[0].file, folder / "own");
    ASSERT_TRUE(kept) << kept.error().message;
    EXPECT_EQ(controllers::keep_leaf(files[0].file, folder / "own").value(), *kept)
        << "the text is there already";
    auto const other = drawn_leaf({ .teeth = 12 });
    auto const others = controllers::write_drawn_leaves(other.state, folder / "cache");
    EXPECT_NE(controllers::keep_leaf(others.at(0).file, folder / "own").value(), *kept);
    auto const tree = our_plant("broadleaf");
    auto const edits
        = methods::foliage_edits(tree, tree.state.active, { .leaves = kept->string() });
    ASSERT_TRUE(edits) << edits.error().message;
    auto const foliated = scene::apply_edits(tree, *edits).value();
    EXPECT_GT(std::ranges::count_if(foliated.in_season->organs,
                                    [&](Organ const& organ) {
                                        return foliated.in_season->organ_shapes[organ.shape].cut
                                            != nullptr;
                                    }),
              100);
    auto const itself
        = methods::foliage_edits(scene, scene.state.active, { .leaves = kept->string() });
    ASSERT_FALSE(itself);
    EXPECT_EQ(itself.error().message,
              "a drawn leaf wears no leaves itself: choose the plant that shall have them");
    fs::remove_all(folder);
}

} // namespace
} // namespace tractus::leaf
