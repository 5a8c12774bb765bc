#include "app/methods/silhouettes/silhouette_file.h"

#include "app/svg/svg_sketch.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::silhouette {
namespace {

SilhouetteFile read_from(std::string const& text)
{
    auto const result = parse_silhouette(text, "tree.json");
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : SilhouetteFile();
}

std::string complaint(std::string const& text)
{
    auto const result = parse_silhouette(text, "tree.json");
    return result ? "it is read" : result.error().message;
}

TEST(SilhouetteFile, ReadsAnOutlineAndATrunk)
{
    auto const file
        = read_from(R"({"outline":[[0,0],[10,0.5],[5,9]],"trunk":[[5,-4],[5,6]],"unit":"mm"})");
    ASSERT_EQ(file.drawing.outline.size(), 1U);
    EXPECT_EQ(file.drawing.outline[0],
              (std::vector<Vec2> { Vec2(0, 0), Vec2(10, 0.5), Vec2(5, 9) }));
    EXPECT_EQ(file.drawing.trunk, (std::vector<Vec2> { Vec2(5, -4), Vec2(5, 6) }));
    EXPECT_TRUE(file.unknown_keys.empty());
}

TEST(SilhouetteFile, ReadsSeveralStrokesAndTellsWhatItDoesNotKnow)
{
    auto const file = read_from(R"({"outline":[[[0,0],[1,0]],[[2,2]]],"colour":3,"trunk":null})");
    EXPECT_EQ(file.drawing.outline.size(), 2U);
    EXPECT_TRUE(file.drawing.trunk.empty());
    EXPECT_EQ(file.unknown_keys, std::vector<std::string> { "colour" });
}

TEST(SilhouetteFile, ReadsPartsOfTheCrown)
{
    auto const file
        = read_from(R"({"outline":[[0,0],[9,0]],"parts":[[[1,1],[2,1]],[[3,1],[4,2],[5,6]]],
                       "styles":[[[7,1],[8,2]]]})");
    ASSERT_EQ(file.styles.size(), 1U);
    EXPECT_EQ(file.styles[0], (std::vector<Vec2> { Vec2(7, 1), Vec2(8, 2) }));
    ASSERT_EQ(file.parts.size(), 2U);
    EXPECT_EQ(file.parts[1], (std::vector<Vec2> { Vec2(3, 1), Vec2(4, 2), Vec2(5, 6) }));
    EXPECT_TRUE(file.unknown_keys.empty());
}

TEST(SilhouetteFile, ReadsTouchesAndLeaves)
{
    auto const file = read_from(R"({"outline":[[0,0],[9,0]],"joins":[[3,4]],"splits":[[1,2],[5,6]],
                       "leaves":[[[1,1],[2,1]]]})");
    EXPECT_TRUE(file.unknown_keys.empty());
    EXPECT_FALSE(file.drawing.is_leaf);
    ASSERT_EQ(file.leaves.size(), 1U);
    ASSERT_EQ(file.touches.size(), 3U);
    EXPECT_EQ(file.touches[1].kind, BumpTouch::Kind::Split);
    EXPECT_EQ(file.touches[1].place, Vec2(5, 6));
    EXPECT_EQ(file.touches[2].kind, BumpTouch::Kind::Join);
    EXPECT_EQ(file.touches[2].place, Vec2(3, 4));
    auto const leaf = read_from(R"({"leaves":[[[1,1],[2,1]],[[7,1],[8,1]]]})");
    EXPECT_TRUE(leaf.drawing.is_leaf);
    EXPECT_EQ(leaf.drawing.outline.at(0), (std::vector<Vec2> { Vec2(1, 1), Vec2(2, 1) }));
    EXPECT_EQ(leaf.leaves.size(), 1U);
    EXPECT_EQ(complaint(R"({"outline":[[0,0]],"splits":[[1,1],[2]]})"),
              "tree.json: point 2 of splits is no point: write [[x, y], [x, y], …] in "
              "millimetres");
}

TEST(SilhouetteFile, SaysWhatIsWrong)
{
    EXPECT_EQ(complaint(R"({"outline":[[0,0]],"parts":[[[1,1]],[[1]]]})"),
              "tree.json: point 1 of part 2 is no point: write [[x, y], [x, y], …] in "
              "millimetres");
    EXPECT_EQ(complaint("[1,"),
              "tree.json: this is no JSON: a bracket, comma or quotation mark is missing or too "
              "many");
    EXPECT_EQ(complaint("{}"),
              "tree.json: it is no drawing: write {\"outline\": [[x, y], …], \"trunk\": [[x, y], "
              "…]}");
    EXPECT_EQ(complaint(R"({"outline":[[0,0],[1]]})"),
              "tree.json: point 2 of outline is no point: write [[x, y], [x, y], …] in "
              "millimetres");
    EXPECT_EQ(complaint(R"({"outline":[[[0,0],["a",1]]]})"),
              "tree.json: point 2 of stroke 1 of outline is no point: write [[x, y], [x, y], …] in "
              "millimetres");
    EXPECT_EQ(complaint(R"({"outline":[[0,0]],"trunk":7})"),
              "tree.json: trunk is no line: write [[x, y], [x, y], …] in millimetres");
}

class SilhouetteSvg : public ::testing::Test {
protected:
    ~SilhouetteSvg() override { std::filesystem::remove(path_); }

    SilhouetteFile read(std::string const& content)
    {
        std::ofstream(path_) << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" "
                                "viewBox=\"0 0 100 100\">"
                             << content << "</svg>";
        auto const result = load_silhouette(path_);
        EXPECT_TRUE(result) << result.error().message;
        return result ? *result : SilhouetteFile();
    }

    std::filesystem::path path_ = std::filesystem::temp_directory_path()
        / ("tractus_silhouette_" + std::to_string(getpid()) + ".svg");
};

TEST_F(SilhouetteSvg, LinesAreWhatTheySay)
{
    auto const file = read(R"(<path id="outline-1" d="M10 20L30 20 30 40"/>
        <path id="Trunk" d="M20 90V50"/><path id="frame" d="M0 0H100"/>
        <path id="part-1" d="M25 20L30 20 30 25"/>)");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_EQ(file.parts[0].front(), Vec2(25, -20));
    ASSERT_EQ(file.drawing.outline.size(), 1U);
    EXPECT_EQ(file.drawing.outline[0].front(), Vec2(10, -20));
    EXPECT_EQ(file.drawing.trunk, (std::vector<Vec2> { Vec2(20, -90), Vec2(20, -50) }));
}

TEST_F(SilhouetteSvg, TouchesAreAtTheMiddlesOfTheirLines)
{
    auto const file = read(R"(<path id="leaf-crown" d="M10 20L30 20 30 40"/>
        <path id="join" d="M4 8H8"/><path id="split 1" d="M20 90V50"/>)");
    EXPECT_TRUE(file.drawing.is_leaf);
    EXPECT_EQ(file.drawing.outline.at(0).front(), Vec2(10, -20));
    ASSERT_EQ(file.touches.size(), 2U);
    EXPECT_EQ(file.touches[0].kind, BumpTouch::Kind::Split);
    EXPECT_EQ(file.touches[0].place, Vec2(20, -70));
    EXPECT_EQ(file.touches[1].kind, BumpTouch::Kind::Join);
    EXPECT_EQ(file.touches[1].place, Vec2(6, -8));
}

TEST_F(SilhouetteSvg, WithoutWordsTheStraightestLineIsTheTrunk)
{
    auto const file
        = read(R"(<path d="M10 20L30 20 30 40 10 40z"/><path d="M20 90L21 70 20 50"/>)");
    EXPECT_EQ(file.drawing.trunk.size(), 3U);
    ASSERT_EQ(file.drawing.outline.size(), 1U);
    auto const alone = read(R"(<path d="M10 20L30 20 30 40 10 40z"/>)");
    EXPECT_TRUE(alone.drawing.trunk.empty());
    EXPECT_EQ(alone.drawing.outline.size(), 1U);
}

} // namespace
} // namespace tractus::silhouette
