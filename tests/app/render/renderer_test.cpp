#include "tests/app/render/renderer_fixture.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace tractus::render {

namespace {

bool leaf_coloured(Color const& color)
{
    return color.green > color.red + 15 && color.green > color.blue + 30;
}

bool bark_coloured(Color const& color)
{
    return color.red > color.blue + 8 && color.red >= color.green && brightness(color) < 450;
}

// Returns the picture of a leaf whose left half is red and right half blue; its upper half is
// transparent.
TextureSlot half_a_picture()
{
    Image image(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            image.at(x, y) = Color { static_cast<std::uint8_t>(x < 32 ? 200 : 20), 20,
                                     static_cast<std::uint8_t>(x < 32 ? 20 : 200),
                                     static_cast<std::uint8_t>(y < 32 ? 255 : 0) };
    std::ostringstream png;
    EXPECT_TRUE(write_png(png, image));
    return std::make_shared<TexturePicture const>(
        TexturePicture { png.str(), TexturePicture::Edges::Clamp });
}

} // namespace

TEST_F(RendererTest, DrawsALeafsPictureAndNothingWhereItIsNot)
{
    auto mesh = post_with_leaves();
    mesh.materials[kLeafMaterial].textures = { .base_color = half_a_picture(),
                                               .alpha = MaterialTextures::Alpha::Mask,
                                               .color = MaterialTextures::Color::Replaced };
    GpuMesh const with_picture(mesh);
    Stage stage;
    stage.meshes.push_back({ &with_picture });
    auto const seen = picture(stage);
    auto const left = at(seen, Vec3(170, 0, 225));
    auto const right = at(seen, Vec3(230, 0, 225));
    EXPECT_GT(left.red, left.blue + 40);
    EXPECT_GT(right.blue, right.red + 40);

    mesh.organs.clear();
    GpuMesh const without(mesh);
    stage.meshes = { { &without } };
    auto const behind = picture(stage);
    EXPECT_EQ(at(seen, Vec3(170, 0, 285)), at(behind, Vec3(170, 0, 285)));
    EXPECT_EQ(at(seen, Vec3(230, 0, 285)), at(behind, Vec3(230, 0, 285)));
}

TEST_F(RendererTest, DrawsSurfacesWhereTheyAre)
{
    auto const picture = post_picture();
    EXPECT_TRUE(bark_coloured(at(picture, Vec3(0, -20, 60))));
    EXPECT_TRUE(bark_coloured(at(picture, Vec3(0, -20, 280))));
    EXPECT_FALSE(bark_coloured(at(picture, Vec3(60, -20, 150))));
}

TEST_F(RendererTest, DrawsEveryInstanceInItsMaterial)
{
    auto const picture = post_picture();
    for (double const x : { -200, 200 })
        for (double const off : { -35, 35 })
            EXPECT_TRUE(leaf_coloured(at(picture, Vec3(x + off, 0, 250 + off)))) << x + off;
    EXPECT_FALSE(leaf_coloured(at(picture, Vec3(110, 0, 250))));
}

TEST_F(RendererTest, ShadesLeavesIndividually)
{
    auto const picture = post_picture();
    EXPECT_NE(at(picture, Vec3(-180, 0, 265)), at(picture, Vec3(220, 0, 265)));
}

TEST_F(RendererTest, ColoursAreTheSameInAnyLight)
{
    GpuMesh const mesh(post_with_leaves(), GpuMesh::Sky::Open);
    Stage stage;
    stage.meshes.push_back({ &mesh });
    stage.backdrop.has_ground = false;
    stage.lighting = Stage::Lighting::Colours;
    auto const colours = picture(stage);
    stage.sun = { .direction = Vec3f(1, 0.4f, 1), .strength = 0.2f };
    EXPECT_EQ(picture(stage), colours);
    stage.lighting = Stage::Lighting::Lit;
    EXPECT_NE(picture(stage), colours);
}

TEST_F(RendererTest, CastsTheShadowAwayFromTheSun)
{
    auto const picture = post_picture();
    // The shaded point is the middle of the left leaf, projected along the sun's rays to the
    // ground. The other point is its mirror image.
    auto const shaded = brightness(at(picture, Vec3(-200 + 250, 100, 0)));
    auto const lit = brightness(at(picture, Vec3(-200 - 250, 100, 0)));
    EXPECT_LT(shaded + 60, lit);
}

TEST_F(RendererTest, FadesTheGroundIntoTheBackdrop)
{
    Stage stage;
    auto const empty = picture(stage);
    stage.backdrop.has_ground = false;
    auto const bare = picture(stage);
    EXPECT_EQ(empty.at(10, 5), bare.at(10, 5));
    EXPECT_NE(empty.at(kWidth / 2, kHeight / 2), bare.at(kWidth / 2, kHeight / 2));
}

// Metal does not scatter light: with it, the sunlit side of a rough block gets darker but keeps its
// hue.
TEST_F(RendererTest, MetalMirrorsInsteadOfScattering)
{
    auto mesh = post_with_leaves();
    auto& post = mesh.materials[kBarkMaterial];
    post = { .name = "pot",
             .kind = Material::Kind::Solid,
             .base_color = { 0.9f, 0.6f, 0.2f },
             .roughness = 0.9f };
    Stage stage;
    stage.sun.direction = Vec3f(0, -1, 0.6f); // The sun shines on the side that the camera sees.
    auto const front = [&](float metalness) {
        post.metalness = metalness;
        GpuMesh const pot(mesh);
        stage.meshes = { { &pot } };
        return at(picture(stage), Vec3(0, -20, 150));
    };
    auto const solid = front(0);
    auto const metal = front(1);
    EXPECT_LT(brightness(metal) + 30, brightness(solid));
    EXPECT_GT(metal.red, metal.blue + 30);
}

// A post that reaches 100 mm below the ground counts as a root. A post that reaches 10 mm down is
// only a base in the ground.
TEST_F(RendererTest, LeavesTheGroundOutWhereItWouldHideRoots)
{
    GpuMesh const mesh(post_with_leaves());
    Stage stage;
    auto const lowered = [&](float depth_mm) {
        stage.meshes = { { &mesh, Eigen::Affine3f(Eigen::Translation3f(0, 0, -depth_mm)) } };
        return picture(stage);
    };
    Vec3 const root(0, -20, -40);
    Vec3 const open_ground(-400, 400, 0);
    auto const with_ground = lowered(10);
    auto const without = lowered(100);
    EXPECT_LT(brightness(at(without, root)) + 60, brightness(at(with_ground, root)));
    stage.meshes.clear();
    stage.backdrop.has_ground = false;
    EXPECT_EQ(at(without, open_ground), at(picture(stage), open_ground));
    EXPECT_NE(at(with_ground, open_ground), at(picture(stage), open_ground));
}

TEST_F(RendererTest, ShowsLightThroughLeaves)
{
    auto mesh = post_with_leaves();
    mesh.surfaces.clear();
    Stage stage;
    stage.sun.direction = Vec3f(0, 1, 0.3f); // The sun shines from behind the plant.
    auto const green = [&](float translucency) {
        mesh.materials[kLeafMaterial].translucency = translucency;
        GpuMesh const leaves(mesh);
        stage.meshes = { { &leaves } };
        return at(picture(stage), Vec3(180, 0, 265)).green;
    };
    EXPECT_GT(green(0.6f), green(0.0f) + 40);
}

TEST_F(RendererTest, GivesTheSamePictureTwice)
{
    EXPECT_EQ(post_picture(), post_picture());
}

TEST_F(RendererTest, PlacesMeshesInTheWorld)
{
    GpuMesh const mesh(post_with_leaves());
    Stage stage;
    stage.meshes.push_back({ &mesh, Eigen::Affine3f(Eigen::Translation3f(150, 0, 0)) });
    auto const moved = picture(stage);
    EXPECT_TRUE(bark_coloured(at(moved, Vec3(150, -20, 60))));
    EXPECT_FALSE(bark_coloured(at(moved, Vec3(0, -20, 60))));
}

TEST_F(RendererTest, DrawsCurvesInTheirColourAndWidth)
{
    Curve curve;
    curve.look = Curve::Look::Flat;
    curve.points = { { Vec3f(-200, 0, 150), Vec3f(1, 0, 0), 10 },
                     { Vec3f(200, 0, 150), Vec3f(1, 0, 0), 10 } };
    GpuCurves const curves(std::span(&curve, 1));
    Stage stage;
    stage.curves.push_back(&curves);
    auto const drawn = picture(stage);
    constexpr Color kRed { 255, 0, 0, 255 };
    int column = 0;
    for (int y = 0; y < kHeight; ++y)
        column += drawn.at(kWidth / 2, y) == kRed ? 1 : 0;
    EXPECT_GE(column, 9);
    EXPECT_LE(column, 10);
    EXPECT_NE(at(drawn, Vec3(230, 0, 150)), kRed);
}

// The edges of shapes and the rim of the ground must be blended with the background and be opaque.
TEST_F(RendererTest, DrawsNothingThatOneSeesThrough)
{
    GpuMesh const mesh(post_with_leaves());
    Curve curve;
    curve.points
        = { { Vec3f(-100, 0, 50), Vec3f(1, 0, 0), 10 }, { Vec3f(100, 0, 250), Vec3f(1, 0, 0), 3 } };
    GpuCurves const curves(std::span(&curve, 1));
    Stage stage;
    stage.meshes.push_back({ &mesh });
    stage.curves.push_back(&curves);
    for (bool const has_ground : { false, true }) {
        stage.backdrop.has_ground = has_ground;
        auto const drawn = picture(stage);
        EXPECT_TRUE(std::all_of(drawn.pixels().begin(), drawn.pixels().end(),
                                [](Color const& pixel) { return pixel.alpha == 255; }))
            << "with ground: " << has_ground;
    }
}

TEST_F(RendererTest, HidesCurvesAboveTheSurface)
{
    Curve curve;
    curve.look = Curve::Look::Flat;
    curve.points
        = { { Vec3f(0, 0, 0), Vec3f(1, 0, 0), 10 }, { Vec3f(0, 0, 300), Vec3f(1, 0, 0), 10 } };
    GpuCurves const curves(std::span(&curve, 1));
    Stage stage;
    stage.curves.push_back(&curves);
    stage.hidden_above_mm = 150;
    auto const drawn = picture(stage);
    constexpr Color kRed { 255, 0, 0, 255 };
    EXPECT_EQ(at(drawn, Vec3(0, 0, 130)), kRed);
    EXPECT_NE(at(drawn, Vec3(0, 0, 170)), kRed);
}

TEST_F(RendererTest, FadesCurvesWithTheDepth)
{
    Curve curve;
    curve.look = Curve::Look::Flat;
    curve.fades = true;
    curve.points
        = { { Vec3f(0, 0, 0), Vec3f(1, 0, 0), 10 }, { Vec3f(0, 0, 300), Vec3f(1, 0, 0), 10 } };
    GpuCurves const curves(std::span(&curve, 1));
    Stage stage;
    stage.curves.push_back(&curves);
    stage.fade = { .color = { 0, 0, 1 }, .share = 1, .from_mm = 150, .range_mm = 300 };
    auto const drawn = picture(stage);
    // Below 150 mm, the curve's colour is mixed with the fade colour; near the ground, half and
    // half.
    EXPECT_NEAR(at(drawn, Vec3(0, 0, 290)).blue, 0, 12) << "above nothing fades";
    EXPECT_NEAR(at(drawn, Vec3(0, 0, 10)).blue, 255 / 2, 12);
    EXPECT_NEAR(at(drawn, Vec3(0, 0, 10)).red, 255 / 2, 12);
}

TEST_F(RendererTest, PutsAWideHeadOnArrows)
{
    Curve arrow;
    arrow.look = Curve::Look::Flat;
    arrow.end = Curve::End::Arrow;
    arrow.points
        = { { Vec3f(0, 0, 50), Vec3f(0, 0, 1), 4 }, { Vec3f(0, 0, 200), Vec3f(0, 0, 1), 4 } };
    GpuCurves const curves(std::span(&arrow, 1));
    Stage stage;
    stage.curves.push_back(&curves);
    auto const drawn = picture(stage);
    constexpr Color kBlue { 0, 0, 255, 255 };
    auto const blue_around = [&](double height) {
        int count = 0;
        for (double x = -30; x < 30; x += 0.5)
            count += at(drawn, Vec3(x, 0, height)) == kBlue ? 1 : 0;
        return count;
    };
    EXPECT_GT(blue_around(204), 2 * blue_around(120));
    EXPECT_GT(blue_around(120), 0);
}

TEST_F(RendererTest, DrawsAsMuchLeafFromAfarAsFromNear)
{
    // A wall of 40 x 40 leaves of 10 mm, which face the user. In the small picture, a leaf is
    // smaller than a pixel.
    mesh::Mesh wall;
    wall.materials.push_back(
        { .name = "leaf", .kind = Material::Kind::Leaf, .base_color = { 0.25f, 0.55f, 0.15f } });
    auto& leaf = wall.organs.emplace_back();
    add_quad(leaf.prototype, { Vec3f(0, 0, 0), Vec3f(5, 5, 0), Vec3f(0, 10, 0), Vec3f(-5, 5, 0) });
    Quatf const upright(Eigen::AngleAxisf(1.5707963f, Vec3f::UnitX()));
    for (int i = 0; i < 1600; ++i)
        leaf.instances.push_back({ .translation_mm = Vec3f(static_cast<float>(i % 40) * 12 - 240, 0,
                                                           static_cast<float>(i / 40) * 12),
                                   .rotation = upright });
    GpuMesh const mesh(wall);
    Stage stage;
    stage.meshes.push_back({ &mesh });
    auto const share = [&](int width) {
        auto const drawn = renderer_->picture(stage, camera(), width, width * 3 / 4);
        double sum = 0;
        for (auto const& pixel : drawn.pixels())
            sum += std::max(0, 2 * pixel.green - pixel.red - pixel.blue - 20);
        return sum / static_cast<double>(drawn.pixels().size());
    };
    double const near = share(1200);
    EXPECT_GT(near, 3);
    EXPECT_NEAR(share(100) / near, 1, 0.25);
}

TEST_F(RendererTest, TakesAnEmptyMesh)
{
    GpuMesh const mesh { mesh::Mesh() };
    Stage stage;
    stage.meshes.push_back({ &mesh });
    EXPECT_EQ(picture(stage).width(), kWidth);
}

} // namespace tractus::render
