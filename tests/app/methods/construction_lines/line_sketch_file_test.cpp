#include "app/methods/construction_lines/line_sketch_file.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::lines {
namespace {

std::string refusal(std::string const& text)
{
    auto const result = parse_line_sketch(text, "s.json");
    if (result)
        return "it is read";
    EXPECT_EQ(result.error().fault, Fault::User);
    return result.error().message;
}

Pattern pattern_of(std::string const& words)
{
    auto const result = parse_line_sketch("{" + words + R"(,"nodes_per_layer":[1]})", "s.json");
    EXPECT_TRUE(result) << result.error().message;
    return result ? result->pattern : Pattern();
}

TEST(LineSketchFile, ReadsLinesAndNumbers)
{
    auto const result = parse_line_sketch(
        R"({"pattern":"distichous","stem":[[0,0],[1,2,3]],"left":[[-5,0],[-5,9]],"right":null,
            "inclinations":[[[0,1],[2,3]]],"nodes_per_layer":[4,5.0],"by":"hand"})",
        "s.json");
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->sketch.stem[1], Vec3(1, 2, 3));
    EXPECT_EQ(result->sketch.left[1], Vec2(-5, 9));
    EXPECT_TRUE(result->sketch.right.empty());
    EXPECT_EQ(result->sketch.inclinations[0][1], Vec2(2, 3));
    EXPECT_EQ(result->sketch.nodes_per_layer, (std::vector<int> { 4, 5 }));
    EXPECT_EQ(result->unknown_keys, std::vector<std::string> { "by" });
}

TEST(LineSketchFile, ReadsPatterns)
{
    EXPECT_EQ(pattern_of(R"("pattern":"spiral")").divergence_deg, 137.5);
    EXPECT_EQ(pattern_of(R"("pattern":"spiral","divergence":99.5)").divergence_deg, 99.5);
    EXPECT_EQ(pattern_of(R"("pattern":"alternate")").divergence_deg, 180);
    EXPECT_EQ(pattern_of(R"("pattern":"alternate","divergence":-120)").divergence_deg, -120);
    EXPECT_EQ(pattern_of(R"("pattern":"whorled")").whorl, 3);
    auto const whorled = pattern_of("\"pattern\":\"whorled(5)\"");
    EXPECT_EQ(whorled.kind, Pattern::Kind::Whorled);
    EXPECT_EQ(whorled.whorl, 5);
}

TEST(LineSketchFile, SaysWhereTheTextIsNoJson)
{
    EXPECT_EQ(refusal("{\n \"stem\": [[0 0]]}"),
              "s.json:2:14: this is no JSON: a bracket, comma or quotation mark is missing or too "
              "many");
    EXPECT_EQ(refusal("").substr(0, 29), "s.json:1:1: this is no JSON: ");
    EXPECT_EQ(refusal("[1e999]"), "s.json: a number in it is too large: give millimetres");
    EXPECT_EQ(refusal("[]").substr(0, 24), "s.json: it is no sketch:");
}

TEST(LineSketchFile, SaysWhatToWrite)
{
    auto const with = [](std::string const& words) {
        return refusal(R"({"pattern":"spiral","nodes_per_layer":[1],)" + words + "}");
    };
    EXPECT_EQ(with(R"("stem":[[0,0],[1,"2"]])"),
              "s.json: point 2 of stem is no point: write [u, v] in millimetres");
    EXPECT_EQ(with(R"("stem":[[0,0],[1,2,3,4]])"),
              "s.json: point 2 of stem is no point: write [u, v] in millimetres");
    EXPECT_EQ(with(R"("left":7)"),
              "s.json: left is no line: write [[u, v], [u, v]] in millimetres");
    EXPECT_EQ(with(R"("inclinations":[[[0,0]],[3]])"),
              "s.json: point 1 of inclination line 2 is no point: write [u, v] in millimetres");
    EXPECT_EQ(with(R"("divergence":"much")"),
              "s.json: divergence is no angle: give degrees from -360 to 360");
    EXPECT_EQ(refusal("{\"pattern\":\"whorled(1)\"}").substr(0, 34),
              "s.json: pattern is \"whorled(1)\": g");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":[1.5]})"),
              "s.json: nodes_per_layer has 1.5: give whole numbers from 0 to 500");
    EXPECT_EQ(refusal(R"({"pattern":"spiral","nodes_per_layer":4})"),
              "s.json: nodes_per_layer is no list: write numbers such as [5, 3]");
}

TEST(LineSketchFile, TakesDeeplyNestedText)
{
    auto const text = std::string(500'000, '[') + std::string(500'000, ']');
    EXPECT_EQ(refusal(text).substr(0, 24), "s.json: it is no sketch:");
}

} // namespace
} // namespace tractus::lines
