#include "engine/lsystem/fast_drawing/interpret.h"

#include "engine/base/vectors.h"
#include "tests/engine/lsystem/small_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

Vec3 tip(Plant const& plant)
{
    return plant.node_position_mm.back();
}

void expect_near(Vec3 const& found, Vec3 const& expected)
{
    EXPECT_LT((found - expected).norm(), 1e-7)
        << found.transpose() << ", expected " << expected.transpose();
}

TEST(Turtle, GrowsUpwards)
{
    auto const plant = drawn("F(100)F");
    ASSERT_EQ(plant.axes.size(), 1u);
    EXPECT_EQ(plant.axes[0].segment_count, 2u);
    expect_near(tip(plant), { 0, 0, 101 });
}

TEST(Turtle, MeasuresInUnits)
{
    auto const model = compiled(with_header("Axiom: F(3)", 0));
    auto const plant = interpret(model, *derive(model));
    ASSERT_TRUE(plant);
    expect_near(tip(*plant), { 0, 0, 30 });
}

TEST(Turtle, TurnsInItsFrame)
{
    expect_near(tip(drawn("+(90)F")), { -1, 0, 0 });
    expect_near(tip(drawn("-(90)F")), { 1, 0, 0 });
    expect_near(tip(drawn("&(90)F")), { 0, 1, 0 }); // Down is the direction away from the user.
    expect_near(tip(drawn("^(90)F")), { 0, -1, 0 });
    expect_near(tip(drawn("/(90)+(90)F")), { 0, 1, 0 });
    expect_near(tip(drawn("\\(90)+(90)F")), { 0, -1, 0 });
    expect_near(tip(drawn("|F")), { 0, 0, -1 });
    expect_near(tip(drawn("+(30)F(2)")), { -1, 0, std::sqrt(3) });
}

TEST(Turtle, TakesItsAngleFromTheView)
{
    expect_near(tip(drawn("+F")), { -std::sqrt(0.5), 0, std::sqrt(0.5) });
    expect_near(tip(drawn("+F", "angle increment: 90\n")), { -1, 0, 0 });
    expect_near(tip(drawn("+F", "angle factor: 4\n")), { -1, 0, 0 });
}

TEST(Turtle, HangsBranchesOnTheSegmentThatBearsThem)
{
    auto const plant = drawn("F[+(90)FF]F[-(90)F]F");
    ASSERT_EQ(plant.axes.size(), 3u);
    EXPECT_EQ(plant.axes[0].segment_count, 3u);
    EXPECT_EQ(plant.axes[1].segment_count, 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
    EXPECT_EQ(plant.axes[2].parent_segment, 1u);
    EXPECT_EQ(plant.axes[2].order, 1u);
    expect_near(plant.positions(plant.axes[1])[0], { 0, 0, 1 });
}

TEST(Turtle, LeavesOutStubs)
{
    auto const plant = drawn("F[F(0)[+(90)F]]");
    ASSERT_EQ(plant.axes.size(), 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
}

TEST(Turtle, BeginsAnAxisBehindAGap)
{
    auto const plant = drawn("Ff(2)F");
    ASSERT_EQ(plant.axes.size(), 2u);
    EXPECT_EQ(plant.axes[1].parent_segment, 0u);
    expect_near(plant.positions(plant.axes[1])[0], { 0, 0, 3 });
}

TEST(Turtle, TakesRadiiFromTheLineWidth)
{
    auto const plant = drawn("!(4)F!(2)F[!(1)+(90)F]!(3)", "line width increment: 0.5\n");
    std::vector<float> const expected { 2, 1, 1.5, 0.5, 0.5 };
    EXPECT_EQ(plant.node_radius_mm, expected);
    auto const stepped = drawn("F#F!!F", "initial line width: 4\nline width increment: 1\n");
    std::vector<float> const expected_stepped { 2, 2.5, 1.5, 1.5 };
    EXPECT_EQ(stepped.node_radius_mm, expected_stepped);
}

TEST(Turtle, UsesThePipeModelWhereTheViewSaysSo)
{
    auto const plant = drawn("F[+(90)F][-(90)F]", "radii: pipe 2 1\n");
    EXPECT_FLOAT_EQ(plant.node_radius_mm[0], std::sqrt(2.0f));
}

TEST(Turtle, RollsUntilItsLeftIsHorizontal)
{
    // The heading is +x, and the turtle is rolled by 50 degrees. @v turns its upper side up, so ^
    // then leads upwards.
    expect_near(tip(drawn("-(90)/(50)@v^(90)F")), { 0, 0, 1 });
    expect_near(tip(drawn("&(90)\\(20)@v^(90)F")), { 0, 0, 1 });
}

TEST(Turtle, ReadsVectorsInTheModelsSpace)
{
    expect_near(tip(drawn("@M(1,2,3)F")), { 1, -3, 3 });
    expect_near(tip(drawn("@R(0,0,1)F")), { 0, -1, 0 });
    expect_near(tip(drawn("@R(1,0,0,0,1,0)^(90)F")), { 0, 0, 1 });
}

TEST(Turtle, BendsTowardsTropisms)
{
    // The heading is -x and T points up. |H x T| = 1 and an elasticity of 0.3 give a rotation of
    // 0.3 radians.
    expect_near(tip(drawn("+(90)F", "tropism: T: 0,1,0 E: 0.3\n")),
                { -std::cos(0.3), 0, std::sin(0.3) });
    expect_near(tip(drawn("+(90)@Ts(1,0.3)F", "tropism: T: 0,1,0\n")),
                { -std::cos(0.3), 0, std::sin(0.3) });
    // The older tropism bends the turtle after the step, by an angle whose sine is the elasticity
    // here.
    expect_near(tip(drawn("+(90)FF", "tropism direction: 0,1,0\ninitial elasticity: 0.3\n")),
                { -1 - std::sqrt(1 - 0.09), 0, 0.3 });
    // The tropism tends to an angle of 90 degrees to T. A turtle that heads along T turns away by
    // the elasticity, in radians.
    auto const away = tip(drawn("F", "tropism: T: 0,1,0 A: 90 E: 0.2\n"));
    EXPECT_NEAR(std::acos(away.z()), 0.2, 1e-9);
}

TEST(Turtle, PlacesOrgansInTheirFrame)
{
    auto const view = "material: 3 green kind=leaf color=0.2,0.6,0.1\norgan: l leaf kind=blade "
                      "material=3 length=2 width=1\n";
    auto const plant = drawn("F[+(90)~l(2)]", view);
    ASSERT_EQ(plant.organs.size(), 1u);
    auto const& organ = plant.organs[0];
    EXPECT_EQ(organ.segment, 0u);
    expect_near(organ.position_mm, { 0, 0, 1 });
    // The y axis of the organ points along the heading.
    expect_near(organ.orientation * Vec3::UnitY(), { -1, 0, 0 });
    // The z axis of the organ points to the turtle's upper side.
    expect_near(organ.orientation * Vec3::UnitZ(), { 0, -1, 0 });
    EXPECT_EQ(organ.scale, Vec3f(2, 2, 2));
    auto const& shape = plant.organ_shapes[organ.shape];
    EXPECT_EQ(shape.length_mm, 2);
    EXPECT_EQ(plant.materials[shape.material].name, "green");
}

TEST(Turtle, DrawsBallsAboutItself)
{
    auto const plant = drawn("F@O(2)");
    ASSERT_EQ(plant.organs.size(), 1u);
    expect_near(plant.organs[0].position_mm, { 0, 0, 0 });
    EXPECT_EQ(plant.organs[0].scale, Vec3f(2, 2, 2));
}

TEST(Turtle, FillsPolygons)
{
    auto const plant = drawn("F{.+(90)f.-(90)F-(90)f}");
    ASSERT_EQ(plant.polygons.size(), 1u);
    EXPECT_EQ(plant.polygons[0].vertex_count, 5u);
    EXPECT_EQ(plant.polygons[0].segment, 0u);
    EXPECT_EQ(plant.segment_count(), 1u);
}

TEST(Turtle, LeavesOutWhatIsNotANumber)
{
    auto const model = compiled(
        with_header("Axiom: F(log(-1))F(exp(1000))F+(log(0))F@M(1e38,1e38,1e38)F[[]]]}", 0));
    auto const result = interpret_with_warnings(model, *derive(model));
    ASSERT_TRUE(result) << result.error().message;
    check_plant(result->plant);
    EXPECT_GE(result->warnings.size(), 3u);
}

TEST(Turtle, DrawsAMillionSegmentsInDeepBrackets)
{
    auto const model
        = compiled(with_header("Axiom: A(1000000)\nhomomorphism\nmaximum depth: 1000000\n"
                               "A(n) : n>0 --> F[&A(n-1)]",
                               0));
    auto const plant = interpret(model, *derive(model));
    ASSERT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    EXPECT_EQ(plant->segment_count(), 1'000'000u);
}

TEST(Turtle, StopsARunawayHomomorphism)
{
    auto const model
        = compiled(with_header("Axiom: A\nhomomorphism\nmaximum depth: 50\nA --> AA", 0));
    auto const plant = interpret(model, *derive(model), { .unit_mm = 10, .max_modules = 10000 });
    ASSERT_FALSE(plant);
    EXPECT_EQ(
        plant.error().message,
        "model.l: the homomorphism makes more than 10000 modules; derive fewer steps or raise the "
        "limit");
}

std::vector<std::string> warnings_of(std::string const& axiom, std::string const& view = {})
{
    auto const model = compiled(with_header("Axiom: " + axiom, 0), view);
    auto const result = interpret_with_warnings(model, *derive(model));
    EXPECT_TRUE(result) << result.error().message;
    return result ? result->warnings : std::vector<std::string>();
}

TEST(Turtle, CarriesItsSidesWhereATropismBends)
{
    auto const view = "tropism: T: 0,1,0 E: 0.3\n";
    // The turtle has both pitch and roll. When the tropism bends it, the roll is lost.
    auto const lost = drawn("&(90)F/(40)F^(90)G", view);
    EXPECT_NEAR(tip(lost).x(), 0, 1e-9);
    // With @Tf, the roll is kept when the tropism bends the turtle.
    auto const kept = drawn("&(90)F/(40)@TfF^(90)G", view);
    EXPECT_GT(std::abs(tip(kept).x()), 0.3);
    // With @Tp, the roll is lost even without a tropism.
    EXPECT_NEAR(tip(drawn("&(90)F&(10)/(40)@Tp^(90)F")).x(), 0, 1e-9);
}

TEST(Turtle, RollsItsUpperSideTowardsATorque)
{
    // The heading is away from the viewer, and the upper side is on the right. The torque points
    // up.
    auto const before = tip(drawn("&(90)\\(90)F^(90)F"));
    auto const after = tip(drawn("&(90)\\(90)F^(90)F", "torque: T: 0,1,0 E: 0.4\n"));
    EXPECT_GT(after.z(), before.z() + 0.2);
}

TEST(Turtle, DrawsPastACutUnlessTheViewForbidsIt)
{
    EXPECT_EQ(drawn("F[F%FF]F").segment_count(), 5u);
    EXPECT_EQ(drawn("F[F%FF]F", "interpretation past %: off\n").segment_count(), 3u);
    EXPECT_EQ(drawn("F[F@mc(1)FF]F").segment_count(), 3u);
    EXPECT_EQ(drawn("F[F@mc(0)FF]F").segment_count(), 5u);
}

TEST(Turtle, ScalesStepsAndSubLSystems)
{
    expect_near(tip(drawn("F@D(2)F@Di(3)F@Dd(2)F")), { 0, 0, 1 + 2 + 6 + 3 });
    expect_near(tip(drawn("F@DiF@DdF", "initial scale: 2\nscale multiplier: 5\n")),
                { 0, 0, 2 + 10 + 2 });
}

TEST(Turtle, DrawsFlatDiscsAndCircles)
{
    auto const disc = drawn("&(90)@c(4)");
    ASSERT_EQ(disc.organs.size(), 1u);
    auto const& organ = disc.organs[0];
    EXPECT_EQ(organ.scale.x(), 4);
    EXPECT_LT(organ.scale.y(), 0.01f);
    // The front of the disc is the turtle's upper side. It faces up when the turtle heads away from
    // the viewer.
    expect_near(organ.orientation * Vec3::UnitY(), { 0, 0, 1 });
    auto const ring = drawn("!(0.2)&(90)@bc(4)@bo(2)");
    ASSERT_EQ(ring.axes.size(), 2u);
    for (auto const& position : ring.positions(ring.axes[0])) {
        EXPECT_NEAR(position.norm(), 2, 1e-9);
        EXPECT_NEAR(position.z(), 0, 1e-9);
    }
    for (auto const& position : ring.positions(ring.axes[1]))
        EXPECT_NEAR(position.y(), 0, 1e-9); // The circle faces the viewer.
    EXPECT_FLOAT_EQ(ring.node_radius_mm[0], 0.1f);
}

TEST(Turtle, TakesWidthsInPixelsForThinLines)
{
    std::string const axiom = "F#F#(4)F";
    auto const in_units = drawn(axiom, "initial line width: 2\nline width increment: 1\n");
    auto const in_pixels = drawn(axiom, "initial line width: 2 pixels\nline width increment: 1\n");
    auto const by_style
        = drawn(axiom, "initial line width: 2\nline width increment: 1\nline style: pixel\n");
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_FLOAT_EQ(in_units.node_radius_mm[i], 1 + 0.5f * static_cast<float>(i));
        EXPECT_FLOAT_EQ(in_pixels.node_radius_mm[i], in_units.node_radius_mm[i] / 20);
        EXPECT_FLOAT_EQ(by_style.node_radius_mm[i], in_units.node_radius_mm[i] / 20);
    }
}

TEST(Turtle, HasOneColorOnBothSides)
{
    std::vector<std::string> const expected {
        "model.l: back faces have the colour of the front; @; "
        "and @, change nothing"
    };
    EXPECT_EQ(warnings_of("F@;F@,(3)F"), expected);
}

TEST(Turtle, LeavesOutLabelsAndTexturesWithOneWarning)
{
    auto const warnings = warnings_of("F@L(\"a label\")F@L(\"other\", 3)@Tx(1)F@Tx(2)");
    std::vector<std::string> const expected { "model.l: labels are not drawn",
                                              "model.l: textures are not supported; @Tx changes "
                                              "nothing" };
    EXPECT_EQ(warnings, expected);
}

// Returns symbols that define a square patch of sixteen points, three units wide.
std::string patch_symbols(std::string const& number)
{
    std::string result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            result += "[" + (row > 0 ? "f(" + std::to_string(row) + ")" : "") + "-(90)"
                + (column > 0 ? "f(" + std::to_string(column) + ")" : "") + "@PC(" + number + ","
                + std::to_string(row) + "," + std::to_string(column) + ")]";
    return result;
}

TEST(Turtle, DrawsSurfacesOfItsOwn)
{
    auto const points = patch_symbols("1");
    auto const plant = drawn("@PS(1)" + points + "@PD(1)f(9)+(90)@PS(1)" + points + "@PD(1)");
    ASSERT_EQ(plant.organs.size(), 2u);
    // The two organs differ only in their positions, so they share one shape.
    EXPECT_EQ(plant.organ_shapes.size(), 1u);
    auto const& shape = plant.organ_shapes[0];
    EXPECT_EQ(shape.kind, OrganShape::Kind::Surface);
    ASSERT_EQ(shape.patches.size(), 1u);
    EXPECT_LT((shape.patches[0].control[15] - Vec3(3, 3, 0)).norm(), 1e-6);
    auto const& second = plant.organs[1];
    expect_near(second.position_mm + second.orientation * Vec3(0, 3, 0), { -3, 0, 9 });
    EXPECT_EQ(warnings_of("@PS(1)@PD(1)").size(), 1u);
    EXPECT_EQ(warnings_of("@PS(1)@PC(1,4,0)").size(), 1u);
}

// Returns a model with a square surface, two units wide and four long. The end point of the surface
// is the middle of its far edge.
Model with_surface(std::string const& axiom, std::string const& view = {})
{
    ModelSource source;
    source.text = with_header("Axiom: " + axiom, 0);
    source.view_text = "surface: l leaf.s 4 5 5\n" + view;
    auto model = compile_model(source, [](std::string const&) -> Result<std::string> {
        std::string text = "0 2 0 4 0 0\nCONTACT POINT  X: 1 Y: 0 Z: 0\nEND POINT  X: 1 Y: 4 Z: 0\n"
                           "HEADING  X: 0 Y: 1 Z: 0\nUP  X: 0 Y: 0 Z: -1\nSIZE: 4\nleaf\n"
                           "TOP COLOR: 0 DIFFUSE: 0 BOTTOM COLOR: 0 DIFFUSE: 0\nAL: ~ A: ~ AR: ~\n"
                           "L: ~ R: ~\nBL: ~ B: ~ BR: ~\n";
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                text += std::to_string(2.0 * column / 3) + " " + std::to_string(4 - 4.0 * row / 3)
                    + " 0\n";
        return text;
    });
    EXPECT_TRUE(model) << model.error().message;
    return *std::move(model);
}

TEST(Turtle, DrawsSurfacesOfTheView)
{
    auto const model = with_surface("F[+(90);(2)~l(2)F];(3)~l(1,2,3)",
                                    "material: 2 green kind=leaf color=0,1,0\n"
                                    "material: 3 wood kind=solid color=1,1,0\n");
    auto const plant = interpret(model, *derive(model), { .unit_mm = 10 });
    ASSERT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    ASSERT_EQ(plant->organs.size(), 2u);
    ASSERT_EQ(plant->organ_shapes.size(), 2u); // There is one shape for each material.
    auto const& leaf = plant->organ_shapes[plant->organs[0].shape];
    EXPECT_EQ(plant->materials[leaf.material].name, "green");
    EXPECT_FALSE(leaf.has_back);
    EXPECT_EQ(leaf.length_mm, 40);
    EXPECT_EQ(leaf.patches[0].control[3], Vec3(10, 40, 0));
    EXPECT_TRUE(plant->organ_shapes[plant->organs[1].shape].has_back);
    EXPECT_EQ(plant->organs[1].scale, Vec3f(1, 2, 3));
    // The turtle continues at the end point of the surface, which is twice as far away at scale 2.
    expect_near(tip(*plant), { -90, 0, 10 });
}

TEST(Turtle, PrintsWhatTheHomomorphismPrints)
{
    auto const model = compiled(with_header("Axiom: A(1)[A(2)]A(3)\nhomomorphism\n"
                                            "A(x) : 1 {printf(\"%g;\", x);} --> F\n",
                                            0));
    auto const string = derive(model).value();
    std::string printed;
    auto const plant
        = interpret(model, string,
                    { .long_branch = 1, .print = [&](std::string_view text) { printed += text; } });
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->segment_count(), 3u);
    EXPECT_EQ(printed, "1;2;3;");
}

TEST(Turtle, DrawsGeneralisedCylinders)
{
    // The generalised cylinder makes a quarter turn: a Hermite curve whose tangents are 1.2 times
    // as long as the distance.
    auto const plant = drawn("!(2)@Gs f(10)+(90)f(10)!(4)@Ge(8)");
    ASSERT_EQ(plant.axes.size(), 1u);
    EXPECT_EQ(plant.axes[0].segment_count, 8u);
    expect_near(tip(plant), { -10, 0, 10 });
    auto const nodes = plant.positions(plant.axes[0]);
    double const length = 1.2 * std::sqrt(200);
    // Expected middle of the Hermite curve: p(1/2) = (p + q) / 2 + (tangent - tangent') / 8
    expect_near(nodes[4], { -5 + length / 8, 0, 5 + length / 8 });
    EXPECT_FLOAT_EQ(plant.node_radius_mm[0], 1);
    EXPECT_FLOAT_EQ(plant.node_radius_mm[4], 1.5);
    EXPECT_FLOAT_EQ(plant.node_radius_mm[8], 2);
    EXPECT_TRUE(plant.node_section.empty());
    // @Gt shortens the tangents. By default there are four rings.
    auto const tight = drawn("@Gt(0.5,0.1)@Gs f(10)+(90)f(10)@Ge");
    EXPECT_EQ(tight.axes[0].segment_count, 4u);
    double const in = 0.5 * std::sqrt(200);
    double const out = 0.1 * std::sqrt(200);
    expect_near(tight.positions(tight.axes[0])[2], { -5 + in / 8, 0, 5 + out / 8 });
}

TEST(Turtle, BranchesGeneralisedCylinders)
{
    auto const plant = drawn("F@Gs f(4)@Gc(2)[+(45)f(4)@Ge(2)F]-(45)f(4)@Ge(2)");
    ASSERT_EQ(plant.axes.size(), 4u);
    // The axis consists of both pieces outside the brackets.
    EXPECT_EQ(plant.axes[1].segment_count, 4u);
    EXPECT_EQ(plant.axes[1].parent_axis, 0u);
    // The branch starts on the second ring of the first piece.
    EXPECT_EQ(plant.axes[2].parent_segment, 2u);
    expect_near(plant.positions(plant.axes[2])[0], { 0, 0, 5 });
    EXPECT_EQ(plant.axes[3].parent_axis, 2u);
}

TEST(Turtle, DrawsPathsAlongControlPoints)
{
    auto const square = "f(6)+(90)f(6)+(90)f(6)+(90)f(6)";
    // A Hermite curve passes through its control points.
    auto const open = drawn("{(1,3)." + std::string(square) + "}(1)");
    ASSERT_EQ(open.axes.size(), 1u);
    EXPECT_EQ(open.axes[0].segment_count, 12u);
    expect_near(open.positions(open.axes[0])[6], { -6, 0, 6 });
    auto const closed = drawn("{(2,3).f(6)+(90)f(6)+(90)f(6)}(2)");
    EXPECT_EQ(closed.axes[0].segment_count, 12u);
    expect_near(tip(closed), { 0, 0, 0 });
    // A B-spline with four control points has one piece, which only comes near them.
    auto const spline = drawn("{(3,2).f(6)+(90)f(6)+(90)f(6)}(3)");
    EXPECT_EQ(spline.axes[0].segment_count, 2u);
    expect_near(spline.positions(spline.axes[0])[0], { -1, 0, 5 });
    expect_near(tip(spline), { -5, 0, 5 });
    auto const ring = drawn("{(4,2).f(6)+(90)f(6)+(90)f(6)}(4)");
    EXPECT_EQ(ring.axes[0].segment_count, 8u);
    expect_near(tip(ring), { -1, 0, 5 });
    EXPECT_EQ(warnings_of("}(1){(7)").size(), 2u);
}

// Returns the names of the materials of all segments, in the order of the axes.
std::string colors_of(std::string const& axiom)
{
    auto const plant = drawn(axiom,
                             "material: 1 r color=1,0,0\nmaterial: 2 g color=0,1,0\n"
                             "material: 3 b color=0,0,1\nmaterial: 4 w color=1,1,1\n");
    std::string names;
    for (auto const& axis : plant.axes) {
        names += names.empty() ? "" : " ";
        for (std::size_t i = 0; i < axis.segment_count; ++i)
            names += plant.materials[plant.segment_material[axis.first_segment + i]].name;
    }
    return names;
}

TEST(Turtle, GivesCylindersTheColorOfEachControlPointBehindItsFirstRing)
{
    EXPECT_EQ(colors_of(";(1)@Gs f(4);(2)@Ge(4)"), "rggg");
    EXPECT_EQ(colors_of(";(1)@Gs;(2)f(4)@Gc(3)f(4);(3)@Ge(5)F"), "rgggbbbb b");
    EXPECT_EQ(colors_of(";(1)@Gs f(4)@Ge(3)"), "rrr");
    // The piece has the colour of its first ring.
    EXPECT_EQ(colors_of(";(1)@Gs f(4);(2)@Ge(1)"), "r");
    EXPECT_EQ(colors_of(";(1)@Gs f(4);(2)@Ge"), "rggg"); // By default there are four rings.
}

TEST(Turtle, GivesBranchesOfCylindersColorsOfTheirOwn)
{
    EXPECT_EQ(colors_of(";(1)@Gs f(4)[+(45);(2)f(4)@Ge(3)]-(45);(3)f(4)@Ge(2)"), "rgg rb");
}

TEST(Turtle, GivesPathsTheColorsOfTheirControlPoints)
{
    EXPECT_EQ(colors_of(";(1){(1,3).;(2)f(6)+(90);(3)f(6)}(1)"), "rgggbb");
    EXPECT_EQ(colors_of(";(1){(2,3).;(2)f(6)+(90);(3)f(6)}(2)"), "rgggbbbrr");
    // A B-spline with four control points has one piece, from near the second point to near the
    // third.
    EXPECT_EQ(colors_of(";(1){(3,3).;(2)f(6)+(90);(3)f(6)+(90);(4)f(6)}(3)"), "gbb");
}

Plant with_contour(std::string const& axiom, std::string const& view = {})
{
    ModelSource source;
    source.text = with_header("Axiom: " + axiom, 0);
    source.view_text = "contour: 5 star.con\ncontour: 9 ribbon.con\n" + view;
    auto const model = compile_model(source, [](std::string const& name) -> Result<std::string> {
        return std::string(name == "star.con" ? "4 2 closed\n-3 -3\n-3 3\n3 3\n3 -3\n"
                                              : "4 2 open\n0 0\n0 1\n0 2\n0 3\n");
    });
    EXPECT_TRUE(model) << model.error().message;
    auto plant = interpret(*model, *derive(*model), { .unit_mm = 1 });
    EXPECT_TRUE(plant) << plant.error().message;
    check_plant(*plant);
    return *std::move(plant);
}

TEST(Turtle, GivesCylindersContours)
{
    auto const plant = with_contour("F@#(9)@!(12)@Gs f(3)@#(5)@Gc(3)f(3)@Ge(3)F");
    ASSERT_EQ(plant.contours.size(), 2u);
    EXPECT_EQ(plant.contours[0].name, "star");
    ASSERT_EQ(plant.axes.size(), 3u);
    ASSERT_EQ(plant.node_section.size(), plant.node_position_mm.size());
    EXPECT_FALSE(has_contour(plant, plant.axes[0]));
    EXPECT_TRUE(has_contour(plant, plant.axes[1]));
    EXPECT_FALSE(has_contour(plant, plant.axes[2])); // The axis of an F has a round section.
    auto const* const sections = &plant.node_section[plant.axes[1].first_node];
    EXPECT_EQ(sections[1].contour, 1);
    EXPECT_EQ(sections[1].next_contour, 0);
    EXPECT_FLOAT_EQ(sections[1].share, 1.0f / 3);
    EXPECT_EQ(sections[4].contour, 0);
    EXPECT_EQ(sections[0].sides, 12);
    EXPECT_LT((sections[2].normal - Vec3f::UnitY()).norm(), 1e-6f);
    EXPECT_EQ(warnings_of("@#(3)@Gs").size(), 1u);
}

TEST(Turtle, KeepsCylindersFiniteWhateverTheyAreTold)
{
    auto const plant = with_contour("@Gr(89,1e30)@Gt(1e30,-1e30)!(1e30)@#(5)@Gs f(1e9)@Gc(1e30)"
                                    "@Gr(1)@Gr(0,-1e30,90,1e30)&(1)f(1e9)@Ge(-5)");
    // with_contour() has also checked the plant, including its numbers, with check_plant().
    EXPECT_EQ(plant.axes.size(), 1u);
    auto const model = with_surface("~l(1e30)~l(1e30,-1e30,0)F~l(0)F@PS(1)@PC(1,1e30,-1)@PD(1e30)");
    auto const surfaces = interpret(model, *derive(model));
    ASSERT_TRUE(surfaces) << surfaces.error().message;
    check_plant(*surfaces);
}

TEST(Turtle, TwistsCylindersWhereTheViewSaysSo)
{
    auto const axiom = "@#(5)@Gs f(4)/(60)@Ge(2)";
    auto const straight = with_contour(axiom);
    auto const twisted = with_contour(axiom, "twist of cylinders: on\n");
    auto const angle_deg = [](Plant const& plant, std::size_t node) {
        auto const& normal = plant.node_section[node].normal;
        return degrees(std::acos(static_cast<double>(normal.y())));
    };
    EXPECT_NEAR(angle_deg(straight, 2), 0, 1e-3);
    EXPECT_NEAR(angle_deg(twisted, 0), 0, 1e-3);
    EXPECT_NEAR(angle_deg(twisted, 1), 30, 1e-3);
    EXPECT_NEAR(angle_deg(twisted, 2), 60, 1e-3);
}

} // namespace
} // namespace tractus::lsystem
