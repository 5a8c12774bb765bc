// Tests every turtle symbol in the manual of cpfg: what the symbol draws, and where it leads the
// turtle.
#include "tests/engine/lsystem/small_model.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::lsystem {
namespace {

// A row of the table. Its symbols are followed by one more F of length 1, whose tip is `tip`. This
// F shows the turtle's position, orientation and scale. The counts do not include it.
struct Row {
    char const* symbols;
    Vec3 tip { 0, 0, 1 };
    std::size_t segments = 0;
    std::size_t organs = 0;
    std::size_t polygons = 0;
    float radius = 0.5f;       // Radius of the additional F.
    char const* color = "one"; // Colour of the additional F.
};

std::string const kSymbolsView
    = "initial line width: 1\ninitial color: 1\ncolor increment: 1\nline width increment: 1\n"
      "angle increment: 90\ntropism direction: 1,0,0\nelasticity increment: 0.5\nscale multiplier: "
      "2\n"
      "interpretation past %: off\n"
      "material: 0 zero kind=solid\nmaterial: 1 one kind=solid\nmaterial: 2 two kind=solid\n"
      "organ: l leaf kind=blade material=1 length=1 width=1\n";
std::string const kTropismView = kSymbolsView + "tropism: T: 1,0,0 A: 0 I: 1 E: 0 S: 0.5\n";

double const kHalf = std::sqrt(0.5);
// Direction after a turn by half a radian towards +x.
Vec3 const kBent { std::sin(0.5), 0, std::cos(0.5) };

std::vector<Row> const kRows {
    // Steps of the turtle, with and without a segment.
    { "F", { 0, 0, 2 }, 1 },
    { "F(3)", { 0, 0, 4 }, 1 },
    { "f", { 0, 0, 2 } },
    { "f(3)", { 0, 0, 4 } },
    { "G(3)", { 0, 0, 4 }, 1 },
    { "g(3)", { 0, 0, 4 } },
    // Symbols for rotations.
    { "+", { -1, 0, 0 } },
    { "+(45)", { -kHalf, 0, kHalf } },
    { "-", { 1, 0, 0 } },
    { "-(45)", { kHalf, 0, kHalf } },
    { "&", { 0, 1, 0 } },
    { "&(45)", { 0, kHalf, kHalf } },
    { "^", { 0, -1, 0 } },
    { "^(45)", { 0, -kHalf, kHalf } },
    { "/+", { 0, 1, 0 } },
    { "/(45)+", { -kHalf, kHalf, 0 } },
    { "\\+", { 0, -1, 0 } },
    { "\\(45)+", { -kHalf, -kHalf, 0 } },
    { "|", { 0, 0, -1 } },
    // Symbols for branches and cuts.
    { "[+F]", { 0, 0, 1 }, 1 },
    { "[F%FF]", { 0, 0, 1 }, 1 },
    { "[F@mc(1)FF]", { 0, 0, 1 }, 1 },
    { "[F@mc(0)FF]", { 0, 0, 1 }, 3 },
    // Symbols for widths and colours.
    { "#(4)", { 0, 0, 1 }, 0, 0, 0, 2 },
    { "!(4)", { 0, 0, 1 }, 0, 0, 0, 2 },
    { "##!", { 0, 0, 1 }, 0, 0, 0, 1 },
    { ";", { 0, 0, 1 }, 0, 0, 0, 0.5f, "two" },
    { ",", { 0, 0, 1 }, 0, 0, 0, 0.5f, "zero" },
    { ";(2)", { 0, 0, 1 }, 0, 0, 0, 0.5f, "two" },
    { ",(0)", { 0, 0, 1 }, 0, 0, 0, 0.5f, "zero" },
    // Polygons and generalised cylinders. By default, there are four segments between two control
    // points.
    { "{F+F+F}", { -1, 0, -1 }, 0, 0, 1 },
    { "{.f.+f.+f.}", { -1, 0, -1 }, 0, 0, 1 },
    { "{G.+F.+F.}", { -1, 0, -1 }, 0, 0, 1 },
    { "{(1)FF}(1)", { 0, 0, 3 }, 4 },
    { "{(2)F+F+F}(1)", { -1, 0, -1 }, 12 },
    { "{(3)FFFFF}(1)", { 0, 0, 6 }, 8 },
    { "{(4)F+F+F+F}(1)", { 1, 0, 0 }, 16 },
    { "@Gsf@Gc(2)f@Ge(3)", { 0, 0, 3 }, 5 },
    { "@Gt(1,2)@Gr(10,1)@Gr(1)@#@!(5)@Gsf@Ge(4)", { 0, 0, 2 }, 4 },
    // Symbols for organs.
    { "~l", { 0, 0, 1 }, 0, 1 },
    { "~l(2)", { 0, 0, 1 }, 0, 1 },
    { "~l(2,3,4)", { 0, 0, 1 }, 0, 1 },
    { "@o", { 0, 0, 1 }, 0, 1 },
    { "@o(2)", { 0, 0, 1 }, 0, 1 },
    { "@O(2)", { 0, 0, 1 }, 0, 1 },
    { "@c(2)", { 0, 0, 1 }, 0, 1 },
    { "@bo(2)", { 0, 0, 1 }, 32 },
    { "@bc(2)", { 0, 0, 1 }, 32 },
    // Position and frame, in the coordinates of the model: y points up, and z towards the viewer.
    { "@M(1,2,3)", { 1, -3, 3 } },
    { "@M(1,2)", { 1, 0, 3 } },
    { "@R(0,0,2)", { 0, -1, 0 } },
    { "@R(2,0)", { 1, 0, 0 } },
    { "@R(2,0)@R(0,0)", { 0, 0, 1 } },
    { "@R(0,1,0,1,0,0)&", { -1, 0, 0 } },
    { "-(45)/(30)@v+", { 0, 1, 0 } },
    { "@D(3)", { 0, 0, 3 } },
    { "@Di", { 0, 0, 2 } },
    { "@Di(3)@Di(2)", { 0, 0, 6 } },
    { "@D(6)@Dd(4)@Dd", { 0, 0, 0.75 } },
    // Symbols for tropisms.
    { "@Ts(1,0.5)", kBent },
    { "@Ts(1,9)@Ts(1)", { 0, 0, 1 } },
    { "@Ti(1,0.5)", kBent },
    { "@Ti(1)", kBent },
    { "@T(1,0.5)", kBent },
    { "@Ti(1,0.8)@Td(1,0.3)", kBent },
    { "@Ti(1,1)@Td(1)", kBent },
    { "_(0.5)f_(0)", { std::sin(kPi / 6), 0, 1 + std::cos(kPi / 6) } },
    { "/@Tf@Tp+", { 0, 1, 0 } },
    // Queries, and symbols that the turtle does not know.
    { "?P(9,9,9)?H(9,9,9)?L(9,9,9)?U(9,9,9)?E(9)" },
    { "ABC(1,2,3)$" },
};

// Returns symbols that define a surface with sixteen points in the string itself.
std::string surface_symbols()
{
    std::string result = "@PS(1)";
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result += "[f(" + std::to_string(row + 1) + ")+f(" + std::to_string(column + 1)
                + ")@PC(1," + std::to_string(row) + "," + std::to_string(column) + ")]";
    return result + "@PD(1)";
}

void expect_row(Row const& row, std::string const& view)
{
    SCOPED_TRACE(row.symbols);
    auto const plant = drawn(std::string(row.symbols) + "F", view);
    ASSERT_FALSE(plant.axes.empty());
    auto const found = plant.node_position_mm.back();
    EXPECT_LT((found - row.tip).norm(), 1e-6)
        << found.transpose() << ", expected " << row.tip.transpose();
    EXPECT_EQ(plant.segment_count(), row.segments + 1);
    EXPECT_EQ(plant.organs.size(), row.organs);
    EXPECT_EQ(plant.polygons.size(), row.polygons);
    EXPECT_FLOAT_EQ(plant.node_radius_mm.back(), row.radius);
    EXPECT_EQ(plant.materials[plant.segment_material.back()].name, row.color);
}

TEST(TurtleSymbols, DrawWhatTheTableSays)
{
    for (auto const& row : kRows) {
        expect_row(row, kTropismView);
        // Without tropisms, the turtle draws common symbols in a fast path.
        if (std::string_view(row.symbols).find("@T") == std::string_view::npos)
            expect_row(row, kSymbolsView);
    }
    auto const surface = surface_symbols();
    expect_row({ surface.c_str(), { 0, 0, 1 }, 0, 1 }, kSymbolsView);
}

std::vector<std::string> warnings_about(std::string const& symbols)
{
    auto const model = compiled(with_header("Axiom: F" + symbols + "F", 0), kSymbolsView);
    auto const result = interpret_with_warnings(model, derive(model).value());
    EXPECT_TRUE(result) << result.error().message;
    // The rest of the string must be drawn in any case.
    EXPECT_TRUE(result && result->plant.segment_count() == 2) << symbols;
    return result ? result->warnings : std::vector<std::string>();
}

TEST(TurtleSymbols, AreLeftOutWithOneSentence)
{
    struct Case {
        char const* symbols;
        char const* warning;
    };
    std::array const cases {
        Case { "@L(\"a\")@L(\"b\",2)", "model.l: labels are not drawn" },
        Case { "@Tx(1)@Tx(2)", "model.l: textures are not supported; @Tx changes nothing" },
        Case { "@;@,@;(3)@,(4)",
               "model.l: back faces have the colour of the front; @; and @, change nothing" },
        Case { "@S(\"rm x\")@S(\"ls\")", "model.l: models run no programs here; @S does nothing" },
        Case { "@Di(0)@Dd(0)@D", "model.l: left out a @D without a scale, or a @Di or @Dd by 0" },
        Case { "@x@x", "model.l: the turtle symbol @x is not supported; it draws nothing" },
    };
    for (auto const& [symbols, warning] : cases)
        EXPECT_EQ(warnings_about(symbols), std::vector<std::string> { warning });
    // Symbols for cpfg's ray tracer, or for other programs, must cause no warning.
    EXPECT_TRUE(warnings_about("@mo(1,2,3)@I(\"a\",2)@J(1,2,3)@Z@Y").empty());
    for (auto const& row : kRows) {
        auto const model
            = compiled(with_header("Axiom: " + std::string(row.symbols), 0), kTropismView);
        auto const result = interpret_with_warnings(model, derive(model).value());
        EXPECT_TRUE(result && result->warnings.empty()) << row.symbols;
    }
}

} // namespace
} // namespace tractus::lsystem
