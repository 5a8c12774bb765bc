#include "engine/lsystem/view/color_files.h"
#include "engine/lsystem/view/contour_file.h"
#include "engine/lsystem/view/surface_file.h"
#include "engine/lsystem/view/triangle_file.h"
#include "engine/lsystem/view/view.h"
#include "tests/corpus.h"
#include "tests/file_bytes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tractus::lsystem {
namespace {

Contour contour(std::string const& text)
{
    auto read = parse_contour("section.con", text);
    EXPECT_TRUE(read) << read.error().message;
    return read ? *std::move(read) : Contour {};
}

std::string contour_error(std::string const& text)
{
    auto const read = parse_contour("section.con", text);
    return read ? "no error" : read.error().message;
}

TEST(Contours, AreWalkedAtEqualSteps)
{
    auto const stripe = contour("cver 1 3\nname: noname\npoints: 4 8\ntype: or\nsamples: 8\n"
                                "0 -6 0 3\n0 -1 0 1\n0 2 0 1\n0 6 0 3\n");
    EXPECT_EQ(stripe.name, "section");
    EXPECT_FALSE(stripe.closed);
    ASSERT_EQ(stripe.points.size(), Contour::kSteps + 1);
    // Each end point is given three times, so the curve reaches it.
    EXPECT_LT((stripe.points.front() - Vec3f(0, -6, 0)).norm(), 1e-5f);
    EXPECT_LT((stripe.points.back() - Vec3f(0, 6, 0)).norm(), 1e-5f);
    for (std::size_t i = 1; i < stripe.points.size(); ++i)
        EXPECT_NEAR(stripe.points[i].y() - stripe.points[i - 1].y(), 12.0 / Contour::kSteps, 1e-3);
}

TEST(Contours, BeginOnTheXAxisAndTurnToY)
{
    // A square about the origin, drawn clockwise from its lower left corner.
    std::string const square = "closed\n-3 -3\n-3 3\n3 3\n3 -3\n";
    auto const outline = contour("4 2 " + square);
    EXPECT_TRUE(outline.closed);
    EXPECT_NEAR(outline.points[0].y(), 0, 1e-5);
    EXPECT_GT(outline.points[0].x(), 1);
    EXPECT_EQ(outline.points.front(), outline.points.back());
    EXPECT_GT(outline.points[5].y(), 0);
    // The spline of the square has a four-fold symmetry.
    EXPECT_LT((outline.points[Contour::kSteps / 4] - Vec3f(0, outline.points[0].x(), 0)).norm(),
              1e-4f);
    auto const backwards = contour("cver 1 2\nname: x\npoints: 4 4\ntype: cr\n"
                                   "3 -3 0 1\n3 3 0 1\n-3 3 0 1\n-3 -3 0 1\n");
    for (std::size_t i = 0; i <= Contour::kSteps; i += 16)
        EXPECT_LT((backwards.points[i] - outline.points[i]).norm(), 1e-4f) << i;
}

TEST(Contours, NameThePlaceOfAnError)
{
    EXPECT_EQ(contour_error("hello\n"),
              "section.con:1: found 'hello', expected 'cver MAJOR MINOR'");
    EXPECT_EQ(contour_error("cver 1 3\ntype: xr\n"),
              "section.con:2: found 'type: xr', expected o(pen) or c(losed)");
    EXPECT_EQ(contour_error("cver 1 3\ntype: or\n0 0 0\n0 1 0\n1 1 0\n"),
              "section.con:5: expected at least 4 control points");
    EXPECT_EQ(contour_error("cver 1 3\ntype: cr\n0 zero 0\n"),
              "section.con:3: expected a control point 'x y z [multiplicity]'");
}

// Returns the file of a flat square patch from y = 0 to 3. Its contact point is in the middle of
// its lower edge.
std::string square_surface(std::string const& frame, std::string const& neighbors = "L: ~ R: ~")
{
    std::string text = "0 3 0 3 0 0\nPRECISION S: 5 T: 5\nCONTACT POINT  X: 1.5 Y: 0 Z: 0\n"
                       "END POINT  X: 1.5 Y: 3.00 Z: 0\n"
        + frame + "SIZE: 3.0\npatch\nTOP COLOR: 0 DIFFUSE: 0.00 BOTTOM COLOR: 0 DIFFUSE: 0.00\n"
        + "AL: ~ A: ~ AR: ~\n" + neighbors + "\nBL: ~ B: ~ BR: ~\n";
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            text += fmt::format("{} {} 0  ", column, 3 - row);
        text += "\n";
    }
    return text;
}

TEST(Surfaces, StandInTheTurtlesFrame)
{
    auto const upright = parse_surface(
        "leaf.s", square_surface("HEADING  X: 0 Y: 1 Z: 0\nUP  X: 0 Y: 0 Z: -1\n"), 6);
    ASSERT_TRUE(upright) << upright.error().message;
    ASSERT_EQ(upright->patches.size(), 1u);
    auto const& patch = upright->patches[0];
    EXPECT_EQ(patch.control[0], Vec3(-3, 6, 0)); // The size of 3 is scaled to 6.
    EXPECT_EQ(patch.control[15], Vec3(3, 0, 0));
    EXPECT_EQ(upright->end_point, Vec3(0, 6, 0));
    // The front of the patch is on the turtle's upper side.
    EXPECT_GT(patch.normal_at(0.5, 0.5).z(), 0);
    // If the surface is modelled with its length along -x, its y direction points to the turtle's
    // right.
    auto const lying = parse_surface(
        "leaf.s", square_surface("HEADING  X: -1 Y: 0 Z: 0\nUP  X: 0 Y: 0 Z: -1\n"), 3);
    ASSERT_TRUE(lying) << lying.error().message;
    EXPECT_EQ(lying->end_point, Vec3(3, 0, 0));
}

TEST(Surfaces, KnowTheirNeighbors)
{
    auto text = square_surface("HEADING  X: 0 Y: 1 Z: 0\nUP  X: 0 Y: 0 Z: -1\n", "L: other R: ~");
    auto const second = square_surface("", "L: ~ R: patch");
    auto const body = second.substr(second.find("patch\n") + 6);
    text += "other\n" + body;
    auto const read = parse_surface("leaf.s", text, 1);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->patches.size(), 2u);
    EXPECT_EQ(read->patches[0].neighbors[BezierPatch::Left], 1);
    EXPECT_EQ(read->patches[0].neighbors[BezierPatch::Right], BezierPatch::kNoPatch);
    EXPECT_EQ(read->patches[1].neighbors[BezierPatch::Right], 0);
}

TEST(Surfaces, NameThePlaceOfAnError)
{
    auto const error_of = [](std::string const& text) {
        auto const read = parse_surface("leaf.s", text, 1);
        return read ? "no error" : read.error().message;
    };
    EXPECT_EQ(error_of("0 1 0 1 0 1\n"), "leaf.s:1: the file ends before 'SIZE:'");
    EXPECT_EQ(error_of("CONTACT POINT X: 1 Y: 2\n"),
              "leaf.s:1: expected 'X: number Y: number Z: number'");
    EXPECT_EQ(error_of("SIZE: 0\n"), "leaf.s:1: expected 'SIZE:' and a number above 0");
    EXPECT_EQ(error_of("HEADING X: 0 Y: 1 Z: 0\nUP X: 0 Y: 2 Z: 0\nSIZE: 1\n"),
              "leaf.s:3: expected HEADING and UP in different directions");
    EXPECT_EQ(error_of("SIZE: 1\nleaf\n1 2 3\n"),
              "leaf.s:3: the file ends before the last patch's 16 points");
    EXPECT_EQ(error_of("SIZE: 1\nleaf\n1 2 x\n"),
              "leaf.s:3: found '1 2 x', expected 16 points of three numbers");
}

TEST(View, ReadsContoursAndSurfaces)
{
    auto const include = [](std::string const& name) -> Result<std::string> {
        if (name == "star.con")
            return std::string("4 2 closed\n-3 -3\n-3 3\n3 3\n3 -3\n");
        if (name == "leaf.s")
            return square_surface("HEADING  X: 0 Y: 1 Z: 0\nUP  X: 0 Y: 0 Z: -1\n");
        return fail(Fault::User, "no such file");
    };
    auto const view = parse_view("model.v",
                                 "contour: 7 star.con\ncontour: 8 none.con\ncontour sides: 12\n"
                                 "twist of cylinders: on\nsurface: l leaf.s 2 10 6\n"
                                 "surface: l leaf.s 3\nsurface: m none.s 1\nline: n leaf.s 1\n"
                                 "initial scale: 2\nscale multiplier: 3\n"
                                 "interpretation past %: off\n",
                                 include);
    ASSERT_TRUE(view) << view.error().message;
    EXPECT_EQ(view->contours.size(), 1u);
    EXPECT_TRUE(view->contours.at(7).closed);
    EXPECT_EQ(view->contour_sides, 12);
    EXPECT_TRUE(view->twist_of_cylinders);
    ASSERT_EQ(view->surfaces.size(), 2u);
    EXPECT_EQ(view->surfaces.at('l').end_point, Vec3(0, 2, 0));
    EXPECT_EQ(view->surfaces.at('n').end_point, Vec3(0, 1, 0));
    EXPECT_EQ(view->scale, 2);
    EXPECT_EQ(view->scale_step, 3);
    EXPECT_FALSE(view->draws_past_cut);
    std::vector<std::string> const expected {
        "model.v:2:1: cannot read the contour none.con (no such file); it is a circle",
        "model.v:6:1: the surface l is defined before; leaf.s is left out",
        "model.v:7:1: cannot read the surface none.s (no such file); it is a plain leaf",
    };
    EXPECT_EQ(view->warnings, expected);
    EXPECT_EQ(parse_view("model.v", "polygonization level: 3\n", {})->contour_sides, 16);
}

TEST(TriangleSurfaces, LieInTheFrameOfOrgans)
{
    auto const surface = parse_triangle_surface("leaf.t",
                                                "// two triangles\ntriangle\n0 0 0 0 0 1\n"
                                                "1, 0, 0 0 0 1\n0 2 0.5\n"
                                                "triangle: 0 0 0\n0 2 0.5\n-1 0 0\n",
                                                10);
    ASSERT_TRUE(surface) << surface.error().message;
    ASSERT_EQ(surface->patches.size(), 2u);
    auto const& patch = surface->patches[0];
    EXPECT_EQ(patch.at(0, 0), Vec3(0, 0, 0));
    EXPECT_EQ(patch.at(1, 0), Vec3(-10, 0, 0)); // The point is on the left of the patch.
    EXPECT_EQ(patch.at(0, 1), Vec3(0, 20, -5));
    EXPECT_EQ(patch.at(1, 1), Vec3(0, 20, -5));
    EXPECT_EQ(surface->end_point, Vec3::Zero());
}

TEST(TriangleSurfaces, NameThePlaceOfAnError)
{
    auto const error = [](std::string const& text) {
        auto const surface = parse_triangle_surface("leaf.t", text, 1);
        return surface ? "no error" : surface.error().message;
    };
    EXPECT_EQ(error("triangle\n0 0 0\n1 x 0\n"),
              "leaf.t:3: expected a vertex: three coordinates, at most 1e6");
    EXPECT_EQ(error("triangle\n0 0 0\n"),
              "leaf.t:2: the file ends before the triangle's last vertex");
    EXPECT_EQ(error("# none\n"), "leaf.t:1: found no triangle");
}

TEST(ColorFiles, BecomeColorsOfTheView)
{
    auto const map = color_map_statements("plant.map", std::string("\0\0\0\xff\x80\0", 6));
    ASSERT_TRUE(map) << map.error().message;
    // A record of a material: number, transparency, ambient, diffuse, emitted, reflected,
    // shininess.
    std::string const record("\x05\x33"
                             "\x10\x10\x10"
                             "\xff\0\x33"
                             "\0\x33\0"
                             "\xff\xff\xff"
                             "\x62",
                             15);
    auto const materials = material_file_statements("plant.mat", record);
    ASSERT_TRUE(materials) << materials.error().message;
    auto const view = parse_view(
        "model.v", "material: 0 soil kind=solid color=0.5,0.4,0.3\n" + *materials + *map, {});
    ASSERT_TRUE(view) << view.error().message;
    ASSERT_EQ(view->materials.size(), 3u);
    // The material in the view overrides the one in the file, whichever comes first.
    EXPECT_EQ(view->materials.at(0).name, "soil");
    auto const& orange = view->materials.at(1);
    EXPECT_LT((orange.base_color - Vec3f(1, 0.502f, 0)).norm(), 1e-3f);
    EXPECT_EQ(orange.kind, Material::Kind::Stem);
    auto const& red = view->materials.at(5);
    EXPECT_LT((red.base_color - Vec3f(1, 0.2f, 0.2f)).norm(), 1e-3f);
    EXPECT_EQ(red.kind, Material::Kind::Leaf);
    EXPECT_NEAR(red.translucency, 0.2, 1e-3);
    // The shininess exponent of 98 gives this roughness.
    EXPECT_NEAR(red.roughness, std::sqrt(0.02), 1e-3);
}

TEST(ColorFiles, SayWhatTheyShouldBe)
{
    EXPECT_EQ(
        color_map_statements("a.map", "ab").error().message,
        "a.map: found 2 bytes, expected a colour map: red, green and blue of 256 colours, 768 "
        "bytes");
    EXPECT_EQ(material_file_statements("a.mat", "ab").error().message,
              "a.mat: found 2 bytes, expected materials: records of 15 bytes");
}

// Every surface and contour in the published models must be readable.
TEST(PublishedShapes, AreRead)
{
    REQUIRE_CORPUS();
    int count = 0;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(corpus() / "lsystems")) {
        if (!entry.is_regular_file())
            continue;
        auto const text = file_bytes(entry.path());
        if (entry.path().extension() == ".s") {
            auto const read = parse_surface(entry.path().string(), text, 1);
            ASSERT_TRUE(read) << read.error().message;
            EXPECT_GE(read->patches.size(), 1u);
            ++count;
        } else if (entry.path().extension() == ".con") {
            auto const read = parse_contour(entry.path().string(), text);
            ASSERT_TRUE(read) << read.error().message;
            ++count;
        }
    }
    EXPECT_GE(count, 8);
}

} // namespace
} // namespace tractus::lsystem
