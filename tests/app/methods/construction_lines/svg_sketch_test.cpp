#include "app/svg/svg_sketch.h"

#include "app/svg/svg_path.h"
#include "app/svg/svg_transform.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tractus::lines {
namespace {

using Line = std::vector<Vec2>;

// Returns the line of SVG path data that describe a single line.
Line path(char const* data)
{
    auto const lines = svg::parse_svg_path(data);
    EXPECT_TRUE(lines) << data;
    EXPECT_TRUE(lines && lines->size() == 1) << data;
    return lines && !lines->empty() ? lines->front() : Line();
}

nlohmann::json sketch_of_svg(std::string const& content, std::string const& attributes = "")
{
    auto const result
        = svg::svg_as_sketch("<?xml version=\"1.0\"?><svg " + attributes
                             + " xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>");
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : nlohmann::json();
}

std::string svg_refusal(std::string const& text)
{
    auto const result = svg::svg_as_sketch(text);
    return result ? "it is read" : result.error().message;
}

TEST(SvgPath, ReadsStraightLinesInAllTheirForms)
{
    EXPECT_EQ(path("M1 2L3,4"), (Line { Vec2(1, 2), Vec2(3, 4) }));
    EXPECT_EQ(path("m1 2 3 4 5-6"), (Line { Vec2(1, 2), Vec2(4, 6), Vec2(9, 0) }));
    EXPECT_EQ(path("M.5.5H2v-1.5e0 1z"),
              (Line { Vec2(0.5, 0.5), Vec2(2, 0.5), Vec2(2, -1), Vec2(2, 0), Vec2(0.5, 0.5) }));
    auto const lines = svg::parse_svg_path("M0 0L1 0M5 5m1 1l2 2");
    ASSERT_TRUE(lines);
    ASSERT_EQ(lines->size(), 2U);
    EXPECT_EQ((*lines)[1], (Line { Vec2(6, 6), Vec2(8, 8) }));
}

TEST(SvgPath, CurvesGoThroughTheirMiddles)
{
    auto const cubic = path("M0 0C0 4 4 4 4 0");
    EXPECT_NEAR((cubic[cubic.size() / 2] - Vec2(2, 3)).norm(), 0, 1e-12);
    auto const quadratic = path("M0 0Q2 4 4 0");
    EXPECT_NEAR((quadratic[quadratic.size() / 2] - Vec2(2, 2)).norm(), 0, 1e-12);
    auto const snake = path("M0 0Q2 4 4 0T8 0");
    EXPECT_NEAR((snake[snake.size() - 13] - Vec2(6, -2)).norm(), 0, 1e-12);
    auto const smooth = path("m0 0c0 4 4 4 4 0s4-4 4 0");
    EXPECT_NEAR((smooth[smooth.size() - 13] - Vec2(6, -3)).norm(), 0, 1e-12);
}

TEST(SvgPath, ArcsAreCirclesAboutTheirMiddles)
{
    for (auto const* const data : { "M10 0A10 10 0 0 1 0 10", "M10 0a10,10 30 01-10 10" })
        for (auto const& point : path(data))
            EXPECT_NEAR(point.norm(), 10, 1e-9) << data;
    auto const large = path("M10 0A10 10 0 1 0 0 10");
    EXPECT_NEAR((large[large.size() / 2] - Vec2(-10, -10) / std::sqrt(2.0)).norm(), 0, 1e-9);
    // The radius is too small for the arc, so it is enlarged to the minimum.
    auto const too_small = path("M-10 0A1 1 0 0 1 10 0");
    EXPECT_NEAR((too_small[too_small.size() / 2] - Vec2(0, -10)).norm(), 0, 1.0);
}

TEST(SvgPath, RefusesWhatIsNoPath)
{
    for (auto const* const data : { "L1 2", "M1", "M1 2 3", "M1 2L", "M1 2X3", "M1 2Z3 4",
                                    "M0 0A1 1 0 2 0 5 5", "M0 0Linf 1", "M1e999 0" })
        EXPECT_FALSE(svg::parse_svg_path(data)) << data;
    EXPECT_TRUE(svg::parse_svg_path("")->empty());
}

TEST(SvgTransform, TheLastIsDoneFirst)
{
    auto const transform = svg::parse_svg_transform("translate(10,20) scale(2)  rotate(90)");
    ASSERT_TRUE(transform);
    EXPECT_NEAR((*transform * Vec2(1, 0) - Vec2(10, 22)).norm(), 0, 1e-12);
    auto const about = svg::parse_svg_transform("rotate(180 5 5)");
    EXPECT_NEAR((*about * Vec2(0, 0) - Vec2(10, 10)).norm(), 0, 1e-12);
    EXPECT_NEAR(
        (*svg::parse_svg_transform("matrix(1 2 3 4 5 6)") * Vec2(1, 1) - Vec2(9, 12)).norm(), 0,
        1e-12);
    EXPECT_FALSE(svg::parse_svg_transform("translate(1"));
    EXPECT_FALSE(svg::parse_svg_transform("turn(1)"));
    EXPECT_FALSE(svg::parse_svg_transform("scale()"));
}

TEST(SvgSketch, ReadsLinesByTheirNamesUprightAndInMillimetres)
{
    auto const read = sketch_of_svg(R"xml(<defs><path id="stem" d="M0 0L9 9"/></defs>
        <path id="Stem-1" d="M100 200V0"/>
        <g id="boundaries" transform="translate(100 200)">
          <polyline class="left" points="-50,0 -50,-300"/>
          <g inkscape:label="right side"><line x1="30" y1="0" x2="30" y2="-300"/></g></g>
        <path class="inclinations" d="M40 100L100 160L140 120M40 40H140"/>
        <path d="M0 0L7 7"/>)xml",
                                    R"(width="200mm" viewBox="0 0 400 600")");
    EXPECT_EQ(read["stem"], nlohmann::json::parse("[[50.0,-100.0],[50.0,0.0]]"));
    EXPECT_EQ(read["left"], nlohmann::json::parse("[[25.0,-100.0],[25.0,50.0]]"));
    EXPECT_EQ(read["right"], nlohmann::json::parse("[[65.0,-100.0],[65.0,50.0]]"));
    EXPECT_EQ(read["inclinations"].size(), 2U);
    EXPECT_FALSE(read.contains("strokes"));
}

TEST(SvgSketch, LinesWithoutNamesAreStrokes)
{
    auto const read = sketch_of_svg(R"(<path d="M0 96V0"/><path d="M-48 0V96"/>)");
    ASSERT_EQ(read["strokes"].size(), 2U);
    // The SVG file is in pixels, 96 per inch.
    EXPECT_DOUBLE_EQ(read["strokes"][0][0][1].get<double>(), -25.4);
}

TEST(SvgSketch, RefusesWhatIsNoDrawing)
{
    EXPECT_EQ(svg_refusal("<html/>"),
              "it is no SVG drawing: save it as SVG, or write the sketch as JSON");
    EXPECT_EQ(svg_refusal("<svg>\n<path></svg>"), "line 2 is no XML: save the drawing again");
    EXPECT_EQ(svg_refusal(""), "line 1 is no XML: save the drawing again");
    EXPECT_EQ(svg_refusal("<svg><circle/></svg>"),
              "it has no path, polyline or line: draw the sketch's lines as paths");
    EXPECT_EQ(svg_refusal("<svg>\n\n<path d='M0 Q'/></svg>"),
              "the path on line 3 cannot be read: draw it again");
    EXPECT_EQ(svg_refusal("<!DOCTYPE svg [<!ENTITY a 'aa'><!ENTITY b '&a;&a;'>]><svg>&b;</svg>"),
              "it declares entities of its own: save it as plain SVG");
}

TEST(SvgSketch, TakesDeeplyNestedGroups)
{
    std::string text = "<svg>";
    for (int i = 0; i < 200'000; ++i)
        text += "<g>";
    EXPECT_EQ(svg_refusal(text), "line 1 is no XML: save the drawing again");
}

} // namespace
} // namespace tractus::lines
