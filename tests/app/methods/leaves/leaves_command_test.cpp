#include "engine/methods/leaves/leaf.h"
#include "tests/app/commands/outcome.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json read_json(fs::path const& path)
{
    std::ifstream file(path);
    return json::parse(file);
}

// Compares the positions of all vertices after the last derivation step with expected ones.
void expect_positions(fs::path const& path, int steps, int final_step, json const& wanted)
{
    std::string const text = file_bytes(path);
    auto const grammar = leaf::parse_grammar(text, path.string());
    ASSERT_TRUE(grammar.has_value());
    auto leaf = leaf::Leaf::begin(*grammar, { .final_step = final_step });
    for (int i = 0; i < steps; ++i)
        ASSERT_TRUE(leaf->derive().has_value());
    std::vector<Vec3> found;
    std::vector<bool> is_seen(leaf->map().vertex_count());
    for (leaf::Dart d = 0; d < static_cast<leaf::Dart>(leaf->map().dart_count()); ++d)
        if (auto const vertex = static_cast<std::size_t>(leaf->map().vertex(d)); !is_seen[vertex]) {
            is_seen[vertex] = true;
            found.push_back(leaf->map().position_of(d));
        }
    ASSERT_EQ(found.size(), wanted.size());
    for (auto const& position : wanted) {
        Vec3 const at(position[0], position[1], position[2]);
        auto const nearest = std::ranges::min_element(
            found, {}, [&](Vec3 const& candidate) { return (candidate - at).norm(); });
        EXPECT_LT((*nearest - at).norm(), 2e-6) << path << " " << position.dump();
        *nearest = Vec3::Constant(1e9);
    }
}

// Compares counts for each grammar in the folder with those of another program.
void expect_counts(fs::path const& folder, std::size_t grammars)
{
    auto const expected = read_json(folder / "counts.json");
    ASSERT_EQ(expected.size(), grammars);
    for (auto const& [name, runs] : expected.items()) {
        auto const path = folder / (name + ".leaf");
        for (auto const& wanted : runs) {
            auto const steps = static_cast<int>(wanted["steps"].size()) - 1;
            auto const final_step = wanted["finalstep"].get<int>();
            auto const outcome = commands::run({ "leaves", "count", path.string(), "--steps",
                                                 std::to_string(steps), "--finalstep",
                                                 std::to_string(final_step) });
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            auto const found = json::parse(outcome.out)["steps"];
            ASSERT_EQ(found.size(), wanted["steps"].size());
            for (std::size_t i = 0; i < found.size(); ++i)
                EXPECT_EQ(found[i], wanted["steps"][i]) << name;
            expect_positions(path, steps, final_step, wanted["positions"]);
        }
    }
}

TEST(LeavesCommand, CountsAreWhatAnotherProgramCounts)
{
    expect_counts(shipped("leaves"), 4);
}

TEST(LeafCorpus, CountsAreWhatAnotherProgramCounts)
{
    REQUIRE_CORPUS();
    expect_counts(corpus() / "leaves", 3);
}

TEST(LeavesCommand, CheckSaysWhatAGrammarHas)
{
    auto const path = shipped("leaves") / "hand.leaf";
    auto const outcome = commands::run({ "leaves", "check", path.string() });
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, path.string() + ": understood: faces 7, rules 7, variables 0\n");
}

TEST(LeavesCommand, CheckSaysWhatIsWrongWhere)
{
    auto const path
        = fs::temp_directory_path() / ("tractus_leaves." + std::to_string(getpid()) + ".leaf");
    std::ofstream(path) << "#define A(4,1,0,0,0,1,1)\n#axiom : A\nr A -> A[B]E\n";
    auto const outcome = commands::run({ "leaves", "check", path.string() });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(path.string() + ":3:10: no face B is defined"), std::string::npos)
        << outcome.err;
    fs::remove(path);
}

TEST(LeavesCommand, TheManualsGrammarIsUnderstood)
{
    std::string const page = file_bytes(shipped("../../app/manual/leaves.md"));
    auto const begin = page.find("\n```\n@");
    ASSERT_NE(begin, std::string::npos);
    auto const grammar = leaf::parse_grammar(
        std::string_view(page).substr(begin + 5, page.find("\n```", begin + 5) - begin - 5),
        "leaves.md");
    ASSERT_TRUE(grammar.has_value()) << grammar.error().message;
    auto leaf = leaf::Leaf::begin(*grammar, { .final_step = 5 });
    for (int i = 0; i < 5; ++i)
        ASSERT_TRUE(leaf->derive().has_value());
    EXPECT_EQ(leaf->face_counts(),
              (std::map<char, std::size_t> {
                  { 'K', 4 }, { 'L', 4 }, { 'M', 5 }, { 'R', 4 }, { 'S', 1 } }));
}

TEST(LeavesCommand, DrawWritesTrianglesOfTheWantedSize)
{
    auto const folder
        = fs::temp_directory_path() / ("tractus_leaves_draw." + std::to_string(getpid()));
    auto const file = folder / "hand.obj";
    auto const outcome
        = commands::run({ "leaves", "draw", (shipped("leaves") / "hand.leaf").string(), "--steps",
                          "7", "--length", "80", "-o", file.string() });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::ifstream lines(file);
    std::size_t triangles = 0;
    Eigen::AlignedBox2d texture;
    for (std::string line; std::getline(lines, line);) {
        triangles += line.starts_with("f ");
        if (Vec2 at; std::sscanf(line.c_str(), "vt %lf %lf", &at.x(), &at.y()) == 2)
            texture.extend(at);
    }
    EXPECT_EQ(triangles, 96U);
    EXPECT_NEAR(texture.sizes().maxCoeff(), 1, 1e-4);
    fs::remove_all(folder);
}

TEST(LeavesCommand, AFileThatIsNotThereIsSaid)
{
    auto const outcome = commands::run({ "leaves", "check", "/nowhere/my.leaf" });
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("/nowhere/my.leaf"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace tractus::leaf
