#include "app/methods/all_leaves.h"

#include "app/batch/plant_season.h"
#include "app/methods/leaves/leaf_library.h"
#include "tests/app/commands/outcome.h"
#include "tests/app/our_plant.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;

// Returns the number of organs that are leaves made by a grammar.
std::size_t leaves_of(Plant const& plant, std::string_view grammar)
{
    return static_cast<std::size_t>(
        std::count_if(plant.organs.begin(), plant.organs.end(), [&](Organ const& organ) {
            auto const& shape = plant.organ_shapes[organ.shape];
            auto const order
                = shape.cut ? lsystem::parse_leaf_sheet_name(shape.cut->sheet) : std::nullopt;
            return order && order->grammar.starts_with(grammar);
        }));
}

scene::Scene foliated_in(scene::Scene const& scene, std::string const& leaves)
{
    auto const edits = methods::foliage_edits(scene, scene.state.active, { .leaves = leaves });
    EXPECT_TRUE(edits) << edits.error().message;
    return edits ? scene::apply_edits(scene, *edits).value() : scene;
}

TEST(SetFoliage, GivesAModelAnotherSpeciesLeaves)
{
    auto const own = our_plant("broadleaf");
    auto const scene = foliated_in(own, "maple");
    EXPECT_EQ(scene.in_season->organs.size(), own.base->organs.size());
    EXPECT_GT(leaves_of(*scene.in_season, "maple"), 100u);
    EXPECT_EQ(leaves_of(*own.in_season, "maple"), 0u);
    EXPECT_EQ(leaves_of(*foliated_in(scene, "").in_season, "maple"), 0u) << "its own again";
    auto const autumn = batch::with_season(scene, scene::Season { .month = 10.5 }).value();
    EXPECT_GT(leaves_of(*autumn.in_season, "maple"), 10u) << "older ones";
    auto const& texture = autumn.in_season->materials.back().textures.base_color;
    EXPECT_NE(texture, scene.in_season->materials.back().textures.base_color);
}

// The text of the user's own grammar must be stored in the document, so that seasons can use it.
TEST(SetFoliage, KeepsAGrammarOfOnesOwn)
{
    auto const file = fs::temp_directory_path() / fmt::format("my own {}.leaf", ::getpid());
    fs::copy_file(own_leaf_path("oak").value(), file, fs::copy_options::overwrite_existing);
    auto const scene = foliated_in(our_plant("broadleaf"), file.string());
    EXPECT_GT(leaves_of(*scene.in_season, "my-own-"), 100u);
    ASSERT_EQ(scene.state.leaf_grammars.size(), 1u);
    fs::remove(file);
    auto const autumn = batch::with_season(scene, scene::Season { .month = 10.5 });
    ASSERT_TRUE(autumn) << autumn.error().message;
    EXPECT_GT(leaves_of(*autumn->in_season, "my-own-"), 10u);
}

TEST(SetFoliage, SaysWhichLeavesThereAre)
{
    auto const scene = our_plant("broadleaf");
    auto const none = methods::foliage_edits(scene, scene.state.active, { .leaves = "mapel" });
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("maple"), std::string::npos) << none.error().message;
    EXPECT_FALSE(
        methods::foliage_edits(scene, scene.state.active, { .leaves = "/nowhere/my.leaf" }));
}

// A leaf sketched over a grammar becomes a grammar of its own, whose leaves a tree then wears.
TEST(SketchLeaf, MakesAGrammarThatPlantsWear)
{
    auto const folder = fs::temp_directory_path() / fmt::format("tractus_sketch_{}", ::getpid());
    fs::create_directories(folder);
    auto const drawing = folder / "mine.txt";
    {
        std::ofstream out(drawing);
        for (int i = 0; i <= 60; ++i)
            out << fmt::format("{:.2f} {:.2f} 0\n", 22 * std::sin(3.14159 * i / 60), 1.4 * i);
        for (int i = 60; i >= 0; --i)
            out << fmt::format("{:.2f} {:.2f} 0\n", -22 * std::sin(3.14159 * i / 60), 1.4 * i);
        out << "\n";
        for (int i = -10; i <= 60; ++i)
            out << fmt::format("0 {:.2f} 0\n", 1.4 * i);
        for (int k = 1; k <= 4; ++k)
            for (int side = -1; side <= 1; side += 2) {
                out << "\n";
                for (int i = 0; i <= 10; ++i)
                    out << fmt::format("{:.2f} {:.2f} 0\n", side * 1.4 * i, 16.0 * k + 1.2 * i);
            }
    }
    auto const grammar = folder / "mine.leaf";
    auto const made
        = commands::run({ "leaves", "fit", drawing.string(), "-o", grammar.string(), "--report" });
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_NE(made.out.find("\"midrib\""), std::string::npos) << made.out;
    auto const checked = commands::run({ "leaves", "check", grammar.string() });
    EXPECT_EQ(checked.exit_code, 0) << checked.err;
    EXPECT_GT(leaves_of(*foliated_in(our_plant("broadleaf"), grammar.string()).in_season, "mine-"),
              100u);
    auto const wrong = commands::run(
        { "leaves", "fit", (folder / "none.json").string(), "-o", grammar.string() });
    EXPECT_NE(wrong.exit_code, 0);
    EXPECT_NE(wrong.err.find("none.json"), std::string::npos) << wrong.err;
    fs::remove_all(folder);
}

} // namespace
} // namespace tractus::leaf
