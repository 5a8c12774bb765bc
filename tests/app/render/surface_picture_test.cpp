#include "engine/export/glb_reader.h"
#include "tests/app/render/renderer_fixture.h"
#include "tests/engine/export/glb_of.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace tractus::render {

namespace {

// Returns a picture whose left half has one colour and whose right half (u > 0.5) has another.
TextureSlot plain_picture(Color const& left, Color const& right)
{
    Image image(16, 16);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            image.at(x, y) = x < 8 ? left : right;
    std::ostringstream png;
    EXPECT_TRUE(write_png(png, image));
    return std::make_shared<TexturePicture const>(
        TexturePicture { png.str(), TexturePicture::Edges::Clamp });
}

TextureSlot plain_picture(Color const& color)
{
    return plain_picture(color, color);
}

std::uint8_t byte_of(double value)
{
    return static_cast<std::uint8_t>(std::lround(127.5 * (value + 1)));
}

// Returns a normal map with the same normal everywhere.
TextureSlot normals_towards(Vec3 const& normal)
{
    return plain_picture({ byte_of(normal.x()), byte_of(normal.y()), byte_of(normal.z()), 255 });
}

Vec3 const kMiddle(0, 0, 150);

// Returns a vertical plate of 200 mm with the given normal, in the middle of the picture and facing
// the user. Its texture coordinate u points to the right and v upwards.
mesh::Mesh plate(Material::Kind kind, Vec3f const& normal = -Vec3f::UnitY())
{
    mesh::Mesh mesh;
    mesh.materials.push_back(
        { .name = "plate", .kind = kind, .base_color = { 0.5f, 0.5f, 0.5f }, .roughness = 1 });
    auto& surface = mesh.surfaces.emplace_back();
    add_quad(surface,
             { Vec3f(-100, 0, 50), Vec3f(100, 0, 50), Vec3f(100, 0, 250), Vec3f(-100, 0, 250) });
    surface.normals.assign(4, normal);
    return mesh;
}

} // namespace

class SurfacePictureTest : public RendererTest {
protected:
    Image picture_of(mesh::Mesh const& mesh, Vec3f const& sun = { -1, -0.4f, 1 })
    {
        GpuMesh const drawn(mesh, GpuMesh::Sky::Open);
        Stage stage;
        stage.meshes.push_back({ &drawn });
        stage.sun.direction = sun;
        return picture(stage);
    }

    int brightness_of(mesh::Mesh const& mesh, Vec3f const& sun = { -1, -0.4f, 1 })
    {
        return brightness(at(picture_of(mesh, sun), kMiddle));
    }
};

TEST_F(SurfacePictureTest, NormalsLeanAsThePictureSays)
{
    // In a normal map, red points along u. Green points against v if the rows are counted along v
    // (glTF 2.0, section 3.9.3).
    for (auto const kind : { Material::Kind::Solid, Material::Kind::Petal, Material::Kind::Bark })
        for (Vec3 const& leaning :
             { Vec3(0.5, 0, 0.866), Vec3(-0.5, 0, 0.866), Vec3(0, 0.6, 0.8), Vec3(0, -0.6, 0.8) }) {
            auto with_picture = plate(kind);
            with_picture.materials[0].textures.normal = normals_towards(leaning);
            // A normal map replaces the procedural relief of bark. So the plates for comparison
            // have a flat one.
            auto turned = plate(kind, Vec3(leaning.x(), -leaning.z(), -leaning.y()).cast<float>());
            turned.materials[0].textures.normal = normals_towards(Vec3::UnitZ());
            auto flat = plate(kind);
            flat.materials[0].textures.normal = normals_towards(Vec3::UnitZ());
            EXPECT_NEAR(brightness_of(with_picture), brightness_of(turned), 9);
            EXPECT_GT(std::abs(brightness_of(with_picture) - brightness_of(flat)), 15);
        }
}

TEST_F(SurfacePictureTest, OcclusionTakesTheSkysLightAndLeavesTheSuns)
{
    auto mesh = plate(Material::Kind::Solid);
    int const open = brightness_of(mesh, Vec3f(0, 1, 0.2f)); // The sun is behind the plate.
    mesh.materials[0].textures.occlusion = plain_picture({ 0, 255, 255, 255 });
    EXPECT_LT(brightness_of(mesh, Vec3f(0, 1, 0.2f)), 20);
    EXPECT_GT(brightness_of(mesh, Vec3f(0, -1, 0.2f)), 250);
    mesh.materials[0].textures.occlusion_strength = 0;
    EXPECT_EQ(brightness_of(mesh, Vec3f(0, 1, 0.2f)), open);
}

TEST_F(SurfacePictureTest, RoughnessAndTranslucencyAreTheMaterialsTimesThePictures)
{
    auto numbers = plate(Material::Kind::Petal);
    numbers.materials[0].roughness = 0.4f;
    numbers.materials[0].translucency = 0.3f;
    auto pictures = plate(Material::Kind::Petal);
    pictures.materials[0].roughness = 0.8f;
    pictures.materials[0].translucency = 0.6f;
    pictures.materials[0].textures.roughness = plain_picture({ 0, 128, 255, 255 });
    pictures.materials[0].textures.translucency = plain_picture({ 0, 0, 0, 128 });
    // In the first position, the sun's light is reflected into the eye. In the second, the sun is
    // behind the plate and its light is transmitted.
    for (auto const& sun : { Vec3f(0, -1, -0.3f), Vec3f(0, 1, 0.2f) }) {
        EXPECT_NEAR(brightness_of(pictures, sun), brightness_of(numbers, sun), 3);
        auto unlike = numbers;
        unlike.materials[0].roughness = 0.8f;
        unlike.materials[0].translucency = 0.6f;
        EXPECT_GT(std::abs(brightness_of(unlike, sun) - brightness_of(numbers, sun)), 6);
    }
}

TEST_F(SurfacePictureTest, WhatAMaskTakesCastsNoShadow)
{
    auto mesh = plate(Material::Kind::Leaf);
    mesh.materials[0].textures.alpha = MaterialTextures::Alpha::Mask;
    mesh.materials[0].textures.base_color
        = plain_picture({ 255, 255, 255, 255 }, { 255, 255, 255, 0 });
    GpuMesh const drawn(mesh, GpuMesh::Sky::Open);
    Stage stage;
    stage.meshes.push_back({ &drawn });
    stage.sun.direction = Vec3f(0, 1, 1); // The shadow falls towards the user.
    auto const seen = picture(stage);
    EXPECT_LT(brightness(at(seen, Vec3(-50, -150, 0))) + 60,
              brightness(at(seen, Vec3(50, -150, 0))));
}

TEST_F(SurfacePictureTest, APlantThroughAFileIsAsLightAsBefore)
{
    auto mesh = post_with_leaves();
    auto read = exports::read_glb(exports::glb_of(mesh));
    ASSERT_TRUE(read) << read.error().message;
    auto const mean = [&](mesh::Mesh const& shown) {
        auto const seen = picture_of(shown);
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (int x = -16; x <= 16; x += 2)
            for (int z = -40; z <= 40; z += 5)
                for (Vec3 const& place : { Vec3(-200 + 2.5 * x, 0, 250 + z), Vec3(x, -20, 150 + z),
                                           Vec3(200 + 2.5 * x, 0, 250 + z) }) {
                    auto const color = at(seen, place);
                    sum += Vec3(color.red, color.green, color.blue);
                    ++count;
                }
        return Vec3(sum / count);
    };
    Vec3 const before = mean(mesh);
    Vec3 const after = mean(*read);
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(after[k], before[k], 8) << k;
}

} // namespace tractus::render
