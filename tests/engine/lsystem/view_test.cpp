#include "engine/lsystem/view/view.h"

#include "engine/lsystem/view/function_file.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

View parsed(std::string const& text)
{
    auto view = parse_view("model.v", text, {});
    EXPECT_TRUE(view) << view.error().message;
    return view ? *std::move(view) : View {};
}

std::string error_of(std::string const& text)
{
    auto const view = parse_view("model.v", text, {});
    return view ? "no error" : view.error().message;
}

TEST(View, ReadsTheSpeciesOfBark)
{
    auto const view = parsed("material: 1 bark kind=bark bark=birch color=0.9,0.9,0.8\n"
                             "material: 2 limb kind=bark bark=young-pine\n"
                             "material: 3 any kind=bark\n");
    EXPECT_EQ(view.materials.at(1).bark, (Bark { BarkKind::Birch, BarkAge::Old }));
    EXPECT_EQ(view.materials.at(2).bark, (Bark { BarkKind::Pine, BarkAge::Young }));
    EXPECT_EQ(view.materials.at(3).bark, Bark {});
    EXPECT_EQ(error_of("material: 1 bark bark=cork\n").find("model.v:1:1: found bark=cork, "), 0U)
        << error_of("material: 1 bark bark=cork\n");
}

TEST(View, ReadsWhatConcernsTheTurtle)
{
    auto const view = parsed(
        "angle factor: 8 // eighths\ninitial color: 3\ncolor increment: 2\n/* a\nb */\n"
        "initial line width: 0.5\nline width increment: 0.1\n"
        "tropism direction: 0.0,-2.0,0.0\ninitial elasticity: 0.2\nelasticity increment: -0.05\n");
    EXPECT_EQ(view.angle_increment_deg, 45);
    EXPECT_EQ(view.color, 3);
    EXPECT_EQ(view.color_step, 2);
    EXPECT_EQ(view.line_width, 0.5);
    EXPECT_EQ(view.line_width_step, 0.1);
    EXPECT_EQ(view.tropism_direction, Vec3(0, -1, 0));
    EXPECT_EQ(view.elasticity, 0.2);
    EXPECT_EQ(view.elasticity_step, -0.05);
    EXPECT_TRUE(view.warnings.empty());
}

TEST(View, ReadsTropisms)
{
    auto const view
        = parsed("tropism: T: 0.0 2.0  0.0 A:90 I: 0.5 E: 0.1 S: 0.01\ntorque: T: 1,0,0\n");
    ASSERT_EQ(view.tropisms.size(), 2u);
    EXPECT_EQ(view.tropisms[0].direction, Vec3(0, 0.5, 0));
    EXPECT_EQ(view.tropisms[0].angle_deg, 90);
    EXPECT_EQ(view.tropisms[0].elasticity, 0.1);
    EXPECT_EQ(view.tropisms[0].elasticity_step, 0.01);
    EXPECT_TRUE(view.tropisms[1].is_torque);
}

TEST(View, ReadsMaterialsAndOrgans)
{
    auto const view = parsed(
        "material: 2 foliage kind=leaf color=0.2,0.5,0.1 roughness=0.6 translucency=0.4\n"
        "organ: p petal kind=blade material=2 length=3 width=1.5 petiole=0.5 widest=0.6 tip=0 "
        "base=2 lobes=0.3 lobe_count=4 fold=10 curl=-20\n");
    auto const& material = view.materials.at(2);
    EXPECT_EQ(material.name, "foliage");
    EXPECT_EQ(material.kind, Material::Kind::Leaf);
    EXPECT_EQ(material.base_color, Vec3f(0.2f, 0.5f, 0.1f));
    EXPECT_EQ(material.translucency, 0.4f);
    ASSERT_EQ(view.organs.size(), 1u);
    auto const& shape = view.organs[0].shape;
    EXPECT_EQ(view.organs[0].letter, 'p');
    EXPECT_EQ(shape.kind, OrganShape::Kind::Blade);
    EXPECT_EQ(shape.material, 2);
    EXPECT_EQ(shape.length_mm, 3); // Lengths are in turtle units until a plant is made.
    EXPECT_EQ(shape.lobe_count, 4);
    EXPECT_NEAR(shape.curl_rad, radians(-20), 1e-12);
}

TEST(View, SaysOnceThatTexturesAreMissing)
{
    auto const view = parsed("texture: F: a.rgb\ntexture: F: b.rgb\n");
    ASSERT_EQ(view.warnings.size(), 1u);
    EXPECT_EQ(
        view.warnings[0],
        "model.v:1:1: 'texture:' is not supported; surfaces have the colours of their materials");
}

TEST(View, WarnsOfUnknownStatementsOnly)
{
    auto const view = parsed("z buffer: on\nlight: V: 5 3 5\nweather: V: 5 3 5\n");
    ASSERT_EQ(view.warnings.size(), 1u);
    EXPECT_EQ(view.warnings[0],
              "model.v:3:1: found 'weather: V: 5 3 5', which is no statement of a view");
}

TEST(View, NamesTheStatementThatWasMeant)
{
    auto const view = parsed("angel factor: 6\nline widht increment: 2\nangle factor 6\n\x1b: 1\n");
    EXPECT_EQ(
        view.warnings,
        (std::vector<std::string> {
            "model.v:1:1: found 'angel factor: 6', which is no statement of a view; 'angle "
            "factor:', perhaps",
            "model.v:2:1: found 'line widht increment: 2', which is no statement of a view; "
            "'line width increment:', perhaps",
            "model.v:3:1: found 'angle factor 6', expected 'key: value'; the line is skipped; "
            "'angle factor:', perhaps",
            "model.v:4:1: found '\\x1b: 1', which is no statement of a view" }));
}

TEST(View, NamesThePlaceOfAnError)
{
    EXPECT_EQ(
        error_of("\norgan: leaf x\n"),
        "model.v:2:1: expected 'organ: LETTER NAME kind=... material=INDEX length=... width=...'");
    EXPECT_EQ(error_of("organ: l leaf length=-1\n"),
              "model.v:1:1: found length=-1, expected 1e-06 to 1000000");
    EXPECT_EQ(error_of("material: 1 x color=1,2\n"),
              "model.v:1:1: found '1,2', expected three numbers");
    EXPECT_EQ(error_of("radii: pipe 2\n"),
              "model.v:1:1: expected 'radii: pipe EXPONENT TIP_RADIUS'");
    EXPECT_EQ(error_of("tropism: T: 0 0 0\n"),
              "model.v:1:1: the tropism direction must not be zero");
}

TEST(Functions, PassThroughTheirEnds)
{
    auto const functions = parse_functions(
        "f.func",
        "fver 1 1\nname: f\nsamples: 1001\nflip: off\npoints: 4\n0 2 1\n0.3333333333333333 3 1\n"
        "0.6666666666666667 3 1\n1 1 1\n");
    ASSERT_TRUE(functions) << functions.error().message;
    ASSERT_EQ(functions->size(), 1u);
    auto const& f = functions->front();
    EXPECT_NEAR(f.at(0), 2, 0.01);
    EXPECT_NEAR(f.at(1), 1, 0.01);
    EXPECT_EQ(f.at(-5), f.at(0));
    EXPECT_EQ(f.at(5), f.at(1));
    // With x = t, this is the Bézier curve of the same points. Its middle is (2 + 9 + 9 + 1) / 8.
    EXPECT_NEAR(f.at(0.5), 21.0 / 8, 0.01);
}

TEST(Functions, RefuseTooFewPoints)
{
    auto const functions = parse_functions("f.func", "fver 1 1\npoints: 2\n0 0\n1 1\n");
    ASSERT_FALSE(functions);
    EXPECT_EQ(functions.error().message, "f.func:4: expected at least 4 control points");
}

CurveTable curve(std::string const& text)
{
    auto read = parse_curve("path.crv", text);
    EXPECT_TRUE(read) << read.error().message;
    return read ? *std::move(read) : CurveTable {};
}

std::string curve_error(std::string const& text)
{
    auto const read = parse_curve("path.crv", text);
    return read ? "no error" : read.error().message;
}

TEST(Curves, AreWalkedByLength)
{
    // A straight line whose control points are dense at its beginning.
    auto const line = curve("points: 4\ndim: 3\ntype: bezier\n0 0 1\n0 0 1\n0 1 1\n0 8 1\n");
    EXPECT_EQ(line.name, "path");
    for (double const share : { 0.0, 0.125, 0.5, 0.77, 1.0 })
        EXPECT_LT((line.at(share) - Vec3(0, 8 * share, 1)).norm(), 2e-3) << share;
    EXPECT_EQ(line.at(-3), Vec3(0, 0, 1));
    EXPECT_EQ(line.at(3), Vec3(0, 8, 1));
}

TEST(Curves, BeginAndEndAsTheirTypeSays)
{
    std::string const square = "0 0\n6 0\n6 6\n0 6\n";
    auto const of_type = [&](std::string const& type) {
        return curve("points: 4\ntype: " + type + "\n" + square);
    };
    // Expected x at the beginning: (0 + 4·6 + 6) / 6 = 5.
    EXPECT_LT((of_type("bspline").at(0) - Vec3(5, 1, 0)).norm(), 1e-12);
    EXPECT_LT((of_type("bspline-endpoint").at(1) - Vec3(0, 6, 0)).norm(), 1e-12);
    EXPECT_LT((of_type("bspline-phantom").at(0) - Vec3(0, 0, 0)).norm(), 1e-12);
    EXPECT_LT((of_type("bspline-phantom").at(1) - Vec3(0, 6, 0)).norm(), 1e-12);
    auto const closed = of_type("bspline-closed");
    EXPECT_LT((closed.at(0) - closed.at(1)).norm(), 1e-12);
    // A quarter of the length of the closed curve.
    EXPECT_LT((closed.at(0.25) - Vec3(5, 5, 0)).norm(), 1e-4);
}

TEST(Curves, RepeatPointsAndSkipAnEditorsCurves)
{
    auto const plain = curve("points: 5\ndim: 3\ntype: bspline\n"
                             "0 0 0\n0 0 0\n0 0 0\n1 2 3\n4 5 6\n");
    auto const repeated = curve("version: 1.0\ncontact: 0 0 0\npoints: 3\nrange: 0 1\ndim: 4\n"
                                "type: bspline\n// first\n0 0 0 3\npoints: 2\ndim: 2\n7 7\n8 8\n"
                                "1 2 3 1\n4 5 6 1\n");
    EXPECT_EQ(plain.control, repeated.control);
    EXPECT_EQ(plain.lengths, repeated.lengths);
}

TEST(Curves, NameThePlaceOfAnError)
{
    EXPECT_EQ(curve_error("points: 4\n0 0\n1 1 1\n"),
              "path.crv:3: expected a control point of 2 numbers");
    EXPECT_EQ(curve_error("points: 4\n0 0\n"),
              "path.crv:2: the file ends before the curve's last point");
    EXPECT_EQ(curve_error("points: 2\n0 0\n1 1\n"), "path.crv: expected at least 4 control points");
    EXPECT_EQ(curve_error("0 0\n"), "path.crv:1: expected 'points:' before the points");
}

TEST(View, SaysThatLinesAreAlwaysTapered)
{
    EXPECT_TRUE(parsed("tapered lines: on\n").warnings.empty());
    auto const warnings = parsed("tapered lines: off\n").warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("always tapered"), std::string::npos) << warnings[0];
}

TEST(View, ReadsCurves)
{
    auto const include = [](std::string const& name) -> Result<std::string> {
        if (name == "a.crv")
            return std::string("points: 4\ntype: bezier\n0 0\n1 0\n2 0\n3 0\n");
        return fail(Fault::User, "no such file");
    };
    auto const view = parse_view("model.v", "curve: a.crv 50\ncurve: b.crv\n", include);
    ASSERT_TRUE(view) << view.error().message;
    ASSERT_EQ(view->curves.size(), 2u);
    EXPECT_EQ(view->curves[0].lengths.size(), 50u);
    EXPECT_LT((view->curves[0].at(0.5) - Vec3(1.5, 0, 0)).norm(), 1e-9);
    EXPECT_EQ(view->curves[1].at(0.5), Vec3::Zero());
    ASSERT_EQ(view->warnings.size(), 1u);
    EXPECT_EQ(view->warnings[0],
              "model.v:2:1: cannot read the curve b.crv (no such file); it is a point");
}

} // namespace
} // namespace tractus::lsystem
