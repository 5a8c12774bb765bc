#include "app/methods/leaves/leaf_library.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <unistd.h>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;

// Ratio of width to height of the blade or leaflet of each species, as known to botanists.
std::map<std::string, double> const kRatios {
    { "ivy", 1.20 },      { "rose", 0.62 },     { "lime", 0.90 },  { "tulip-tree", 1.09 },
    { "chestnut", 0.30 }, { "oak", 0.67 },      { "maple", 1.22 }, { "ginkgo", 1.47 },
    { "clover", 0.68 },   { "grass", 0.07 },    { "birch", 0.78 }, { "beech", 0.64 },
    { "willow", 0.16 },   { "magnolia", 0.52 },
};

TEST(LeafSpecies, AreAllThere)
{
    auto const names = leaf_names();
    EXPECT_EQ(names.size(), 15u);
    for (auto const& [name, ratio] : kRatios)
        EXPECT_TRUE(std::ranges::find(names, name) != names.end()) << name;
}

TEST(LeafSpecies, AreAsWideAsTheyAreKnownToBe)
{
    for (auto const& [name, ratio] : kRatios) {
        auto const grammar = load_leaf_grammar(name);
        ASSERT_TRUE(grammar.has_value()) << grammar.error().message;
        auto const grown = grow_leaf(*grammar, { .variation = 0 });
        ASSERT_TRUE(grown.has_value()) << grown.error().message;
        Eigen::AlignedBox2d box;
        for (auto const& at : grown->leaf.outline().line())
            box.extend(at);
        EXPECT_NEAR(box.sizes().x() / box.sizes().y() / ratio, 1, 0.05) << name;
    }
}

// The triangles of a leaf must fill its outline: for leaves with one blade, their area, without the
// petiole, must be that inside the outline.
TEST(LeafSpecies, FillTheirOutlines)
{
    for (auto const& name : leaf_names()) {
        if (name == "rose" || name == "clover" || name == "fern")
            continue;
        auto const grammar = load_leaf_grammar(name);
        auto const grown = grow_leaf(*grammar, { .variation = 0 });
        ASSERT_TRUE(grown.has_value()) << grown.error().message;
        double wanted = 0;
        auto const& line = grown->leaf.outline().line();
        for (std::size_t i = 0; i < line.size(); ++i) {
            auto const& a = line[i];
            auto const& b = line[(i + 1) % line.size()];
            wanted += 0.5 * (a.x() * b.y() - a.y() * b.x());
        }
        double found = 0;
        auto const& triangles = grown->triangles;
        for (auto const* const part : { &triangles.veins, &triangles.limb })
            for (auto const& [a, b, c] : *part) {
                Vec2 const u = triangles.flat[b] - triangles.flat[a];
                Vec2 const v = triangles.flat[c] - triangles.flat[a];
                found += 0.5 * (u.x() * v.y() - u.y() * v.x());
            }
        auto const stalk = grown->leaf.veins().front();
        found -= (stalk.half_width_from + stalk.half_width_to) * (stalk.to - stalk.from).norm();
        EXPECT_NEAR(found / wanted, 1, 0.04) << name;
    }
}

// When a leaf curls in space, its surface must keep the area of the flat leaf.
TEST(LeafSpecies, LoseNothingOfTheirAreaAsTheyCurl)
{
    auto const area = [](leaf::Grammar const& grammar, double age) {
        auto const grown = grow_leaf(grammar, { .age = age, .variation = 0 });
        double sum = 0;
        for (auto const* const part : { &grown->triangles.veins, &grown->triangles.limb })
            for (auto const& [a, b, c] : *part) {
                Vec2 const u = grown->triangles.flat[b] - grown->triangles.flat[a];
                Vec2 const v = grown->triangles.flat[c] - grown->triangles.flat[a];
                sum += 0.5 * (u.x() * v.y() - u.y() * v.x());
            }
        return sum;
    };
    for (auto const& name : leaf_names()) {
        auto const grammar = load_leaf_grammar(name);
        EXPECT_NEAR(area(*grammar, 1) / area(*grammar, 0.5), 1, 1e-9) << name;
    }
}

TEST(LeafSpecies, AreWholeAtEveryAge)
{
    for (auto const& name : leaf_names()) {
        auto const grammar = load_leaf_grammar(name);
        for (std::uint64_t seed = 0; seed < 10; ++seed) {
            auto const grown = grow_leaf(*grammar, { .age = double(seed) / 9, .seed = seed });
            ASSERT_TRUE(grown.has_value()) << grown.error().message;
            EXPECT_EQ(grown->leaf.map().fault(), "") << name << " " << seed;
            EXPECT_EQ(grown->leaf.map().counts().euler_characteristic(), 1) << name << " " << seed;
            EXPECT_FALSE(grown->triangles.limb.empty()) << name << " " << seed;
        }
    }
}

class PaintCommand : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("tractus-paint-" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // Returns the width and height of a PNG file in pixels, from its bytes 16 to 23.
    static std::pair<unsigned, unsigned> png_size(fs::path const& path)
    {
        std::string const bytes = file_bytes(path);
        EXPECT_EQ(bytes.substr(1, 3), "PNG") << path;
        auto const number = [&](std::size_t at) {
            unsigned value = 0;
            for (std::size_t i = at; i < at + 4 && i < bytes.size(); ++i)
                value = 256 * value + static_cast<unsigned char>(bytes[i]);
            return value;
        };
        return { number(16), number(20) };
    }

    fs::path folder_;
};

TEST_F(PaintCommand, WritesTheMapsOfAMaterial)
{
    auto const to = (folder_ / "maps").string();
    auto const outcome
        = commands::run({ "leaves", "paint", "oak", "birch", "--count", "2", "--pixels", "64",
                          "--age", "0.3", "--age-to", "0.9", "-o", to });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    for (auto const* const name :
         { "color.png", "normal.png", "occlusion-roughness.png", "translucency.png" })
        EXPECT_EQ(png_size(fs::path(to) / name), std::pair(128u, 128u)) << name;
    std::ifstream file(fs::path(to) / "leaves.json");
    auto const page = nlohmann::json::parse(file);
    ASSERT_EQ(page["cells"].size(), 4u);
    EXPECT_EQ(page["cells"][3]["leaf"], "birch");
    EXPECT_EQ(page["cells"][3]["x"], 64);
    EXPECT_EQ(page["cells"][3]["y"], 64);
    EXPECT_EQ(page["cells"][3]["age"], 0.9);
}

TEST_F(PaintCommand, WritesAPicture)
{
    auto const to = (folder_ / "leaf.png").string();
    auto const outcome = commands::run({ "leaves", "paint", "maple", "--pixels", "80", "-o", to });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(png_size(to), std::pair(80u, 80u));
}

TEST_F(PaintCommand, DrawsWhatRollsUpAsItGrowsOld)
{
    auto const height = [&](std::string const& age) {
        auto const to = (folder_ / "leaf.obj").string();
        EXPECT_EQ(commands::run({ "leaves", "draw", "beech", "--age", age, "-o", to }).exit_code,
                  0);
        std::ifstream file(to);
        double low = 1e9;
        double high = -1e9;
        for (std::string word; file >> word;)
            if (double x = 0, y = 0, z = 0; word == "v" && file >> x >> y >> z) {
                low = std::min(low, y);
                high = std::max(high, y);
            }
        return high - low;
    };
    EXPECT_LT(height("1"), 0.9 * height("0.5"));
}

TEST_F(PaintCommand, PutsItsPicturesOnALeaf)
{
    auto const to = (folder_ / "leaf.glb").string();
    auto const outcome
        = commands::run({ "leaves", "draw", "oak", "--paint", "64", "--age", "0.8", "-o", to });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    std::string const bytes = file_bytes(to);
    std::size_t const length
        = static_cast<unsigned char>(bytes[12]) + 256u * static_cast<unsigned char>(bytes[13]);
    auto const gltf = nlohmann::json::parse(bytes.substr(20, length));
    ASSERT_EQ(gltf["materials"].size(), 1u);
    auto const& material = gltf["materials"][0];
    EXPECT_EQ(material["alphaMode"], "MASK");
    EXPECT_EQ(material["doubleSided"], true);
    EXPECT_TRUE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
    EXPECT_TRUE(material["pbrMetallicRoughness"].contains("metallicRoughnessTexture"));
    EXPECT_TRUE(material.contains("normalTexture"));
    EXPECT_EQ(gltf["images"].size(), 3u);
}

TEST_F(PaintCommand, RefusesToPaintWhatItsPictureWouldNotShow)
{
    auto const to = (folder_ / "leaf.png").string();
    auto const outcome = commands::run({ "leaves", "draw", "oak", "--paint", "64", "-o", to });
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(outcome.err.find("shows no painting"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(to));
}

TEST_F(PaintCommand, NamesTheLeavesThatThereAre)
{
    auto const outcome
        = commands::run({ "leaves", "paint", "oka", "-o", (folder_ / "x.png").string() });
    EXPECT_NE(outcome.exit_code, 0);
    EXPECT_NE(
        outcome.err.find(
            "there is no leaf oka (did you mean oak?): give the path of a leaf grammar, or one of "
            "beech, birch"),
        std::string::npos)
        << outcome.err;
    EXPECT_NE(commands::run({ "leaves", "list" }).out.find("tulip-tree"), std::string::npos);
}

} // namespace
} // namespace tractus::leaf
