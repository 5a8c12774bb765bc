#include "engine/export/glb_reader.h"

#include "engine/base/random.h"
#include "engine/export/glb_writer.h"
#include "engine/export/gltf_material.h"
#include "engine/export/read_materials.h"
#include "engine/mesh/make_mesh.h"
#include "tests/engine/export/glb_of.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/sample_plants.h"

#include <cstring>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>

namespace tractus::exports {
namespace {

// Returns the bytes of a .glb file with a JSON text and without a binary chunk.
std::string glb_of_json(std::string json)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";
    auto const append
        = [&](std::uint32_t value) { bytes.append(reinterpret_cast<char const*>(&value), 4); };
    append(2);
    append(static_cast<std::uint32_t>(20 + json.size()));
    append(static_cast<std::uint32_t>(json.size()));
    return bytes + "JSON" + json;
}

std::string error_of(std::string const& bytes)
{
    auto const mesh = read_glb(bytes);
    EXPECT_FALSE(mesh);
    return mesh ? "" : mesh.error().message;
}

void expect_near(std::span<Vec3f const> a, std::span<Vec3f const> b, float tolerance)
{
    ASSERT_EQ(a.size(), b.size());
    float worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, (a[i] - b[i]).norm());
    EXPECT_LE(worst, tolerance);
}

TEST(GlbReader, ReadsBackWhatWasWritten)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const read = read_glb(glb_of(mesh, kInstanced));
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->surfaces.size(), 1u);
    EXPECT_EQ(read->surfaces[0].indices, mesh.surfaces[0].indices);
    expect_near(read->surfaces[0].positions_mm, mesh.surfaces[0].positions_mm, 2e-3f);
    expect_near(read->surfaces[0].normals, mesh.surfaces[0].normals, 1e-5f);
    EXPECT_EQ(read->surfaces[0].texture_coordinates, mesh.surfaces[0].texture_coordinates);
    ASSERT_EQ(read->organs.size(), 1u);
    EXPECT_EQ(read->organs[0].prototype.indices, mesh.organs[0].prototype.indices);
    expect_near(read->organs[0].prototype.positions_mm, mesh.organs[0].prototype.positions_mm,
                1e-4f);
    EXPECT_EQ(read->triangle_count(), mesh.triangle_count());
}

TEST(GlbReader, ReadsInstancesBackInEitherForm)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    for (auto const form : { GlbOptions::Organs::Instanced, GlbOptions::Organs::Nodes }) {
        auto const read = read_glb(glb_of(mesh, { .organs = form }));
        ASSERT_TRUE(read) << read.error().message;
        ASSERT_EQ(read->organs.size(), 1u);
        ASSERT_EQ(read->organs[0].instances.size(), mesh.organs[0].instances.size());
        // Nodes may come in any order. So the comparison uses the sum of all instances of a point.
        auto const sum = [](mesh::InstancedMesh const& organ) {
            Vec3 total = Vec3::Zero();
            for (auto const& instance : organ.instances)
                total += (instance.translation_mm
                          + instance.rotation * instance.scale.cwiseProduct(Vec3f(1, 20, 300)))
                             .cast<double>();
            return total;
        };
        EXPECT_LT((sum(read->organs[0]) - sum(mesh.organs[0])).norm(), 1);
    }
}

TEST(GlbReader, ReadsMergedOrgansAsTrianglesOfTheirMaterial)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const read = read_glb(glb_of(mesh));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->organs.empty());
    ASSERT_EQ(read->surfaces.size(), 2u);
    EXPECT_EQ(read->triangle_count(), mesh.triangle_count());
    auto const& leaves = read->surfaces[1];
    EXPECT_EQ(read->materials[leaves.material].kind, Material::Kind::Leaf);
    auto const& [prototype, instances, shape] = mesh.organs[0];
    std::vector<Vec3f> expected;
    for (auto const& instance : instances)
        for (auto const& position : prototype.positions_mm)
            expected.push_back(instance.translation_mm
                               + instance.rotation * instance.scale.cwiseProduct(position));
    expect_near(leaves.positions_mm, expected, 2e-3f);
}

TEST(GlbReader, ReadsMaterialsBack)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const read = read_glb(glb_of(mesh, kInstanced));
    ASSERT_TRUE(read);
    ASSERT_EQ(read->materials.size(), 2u);
    auto const& leaf = read->materials[read->organs[0].prototype.material];
    EXPECT_EQ(leaf.name, "leaf");
    EXPECT_EQ(leaf.kind, Material::Kind::Leaf);
    // The colour was made lighter when it was written, because the default picture of veins is
    // darker than white.
    Vec3 const light
        = linear_color(leaf.base_color).cwiseQuotient(linear_color(mesh.materials[1].base_color));
    EXPECT_NEAR(light.minCoeff(), light.maxCoeff(), 1e-3);
    EXPECT_GT(light.x(), 1.2);
    EXPECT_FLOAT_EQ(leaf.roughness, 0.6f);
    EXPECT_FLOAT_EQ(leaf.translucency, 0.4f);
}

// The transform first scales, then rotates, and then translates. In glTF's texture coordinates, in
// which v grows downwards, a quarter turn takes u to -v.
TEST(GlbReader, PlacesPicturesAsTheirTransformSays)
{
    tinygltf::Material material;
    EXPECT_TRUE(texture_transform(material).isApprox(Eigen::Affine2f::Identity()));
    material.normalTexture.index = 0;
    material.normalTexture.extensions["KHR_texture_transform"] = tinygltf::Value(
        tinygltf::Value::Object { { "offset",
                                    tinygltf::Value(tinygltf::Value::Array {
                                        tinygltf::Value(0.5), tinygltf::Value(0.25) }) },
                                  { "rotation", tinygltf::Value(kPi / 2) },
                                  { "scale",
                                    tinygltf::Value(tinygltf::Value::Array {
                                        tinygltf::Value(2.0), tinygltf::Value(3.0) }) } });
    auto const place = texture_transform(material);
    EXPECT_LT((place * Vec2f(1, 0) - Vec2f(0.5f, 0.25f - 2)).norm(), 1e-6f);
    EXPECT_LT((place * Vec2f(0, 1) - Vec2f(0.5f + 3, 0.25f)).norm(), 1e-6f);
    // The texture with this index does not exist.
    material.pbrMetallicRoughness.baseColorTexture.index = 0;
    EXPECT_TRUE(texture_transform(material).isApprox(Eigen::Affine2f::Identity()));
}

TEST(GlbReader, ReadsTheColorsPictureAndItsMask)
{
    auto mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const picture = std::make_shared<TexturePicture const>(
        TexturePicture { "\x89PNG and more", TexturePicture::Edges::Clamp });
    auto const leaves = mesh.organs[0].prototype.material;
    mesh.materials[leaves].textures
        = { .base_color = picture, .alpha = MaterialTextures::Alpha::Mask };
    auto const read = read_glb(glb_of(mesh, kInstanced));
    ASSERT_TRUE(read) << read.error().message;
    auto const& textures = read->materials[read->organs[0].prototype.material].textures;
    ASSERT_TRUE(textures.base_color);
    EXPECT_EQ(textures.base_color->bytes, picture->bytes);
    EXPECT_EQ(textures.base_color->edges, TexturePicture::Edges::Clamp);
    EXPECT_EQ(textures.alpha, MaterialTextures::Alpha::Mask);
    auto const& bark = read->materials[read->surfaces[0].material].textures;
    EXPECT_EQ(bark.alpha, MaterialTextures::Alpha::Opaque);
}

TEST(GlbReader, ReadsEveryPictureAndHowMuchItCounts)
{
    auto mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const picture = [](char const* bytes) {
        return std::make_shared<TexturePicture const>(
            TexturePicture { bytes, TexturePicture::Edges::Clamp });
    };
    auto const roughness = picture("roughness");
    auto const leaves = mesh.organs[0].prototype.material;
    mesh.materials[leaves].textures = { .base_color = picture("\xff\xd8 of a JPEG file"),
                                        .normal = picture("normal"),
                                        .occlusion = roughness,
                                        .roughness = roughness,
                                        .translucency = picture("passes"),
                                        .normal_strength = 0.5f,
                                        .occlusion_strength = 0.25f };
    auto const read = read_glb(glb_of(mesh, kInstanced));
    ASSERT_TRUE(read) << read.error().message;
    auto const& textures = read->materials[read->organs[0].prototype.material].textures;
    ASSERT_TRUE(textures.base_color && textures.normal && textures.roughness
                && textures.translucency);
    EXPECT_EQ(textures.base_color->bytes, "\xff\xd8 of a JPEG file");
    EXPECT_EQ(textures.normal->bytes, "normal");
    EXPECT_EQ(textures.roughness->bytes, "roughness");
    // The file has one picture for both textures, not two equal ones.
    EXPECT_EQ(textures.occlusion, textures.roughness);
    EXPECT_EQ(textures.translucency->bytes, "passes");
    EXPECT_FLOAT_EQ(textures.normal_strength, 0.5f);
    EXPECT_FLOAT_EQ(textures.occlusion_strength, 0.25f);
}

TEST(GlbReader, PlacesPlantsWhereTheyStand)
{
    auto const mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    mesh::Mesh const other = mesh::make_mesh(mesh::single_axis(1, 2, 2));
    PlacedMesh const plants[]
        = { { .mesh = &mesh },
            { .position_mm = { 1000, 500, 30 }, .rotation_rad = kPi / 2, .mesh = &other } };
    auto const read = read_glb(glb_of(plants));
    ASSERT_TRUE(read) << read.error().message;
    auto const& positions = read->surfaces[0].positions_mm;
    auto const& own = other.surfaces[0].positions_mm;
    for (std::size_t i = 0; i < own.size(); ++i) {
        Vec3f const expected(1000 - own[i].y(), 500 + own[i].x(), 30 + own[i].z());
        EXPECT_LT((positions[mesh.surfaces[0].positions_mm.size() + i] - expected).norm(), 1e-2f);
    }
    mesh::expect_sound(read->surfaces[0]);
    EXPECT_EQ(mesh::inside_out_count(read->surfaces[0]), 0u);
}

TEST(GlbReader, SaysWhatIsWrong)
{
    EXPECT_NE(error_of("").find("not a binary glTF"), std::string::npos);
    EXPECT_NE(error_of("solid cube").find("not a binary glTF"), std::string::npos);
    auto const glb = glb_of(mesh::make_mesh(mesh::single_axis(1, 1, 1)));
    EXPECT_NE(error_of(glb.substr(0, 15)).find("truncated"), std::string::npos);
    EXPECT_NE(error_of(glb.substr(0, glb.size() - 4)).find("truncated"), std::string::npos);
    EXPECT_NE(error_of(glb_of_json("{\"asset\":")).find("cannot read"), std::string::npos);
    EXPECT_NE(
        error_of(glb_of_json(
                     R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_draco_mesh_compression"],
        "extensionsRequired":["KHR_draco_mesh_compression"]})"))
            .find("KHR_draco_mesh_compression"),
        std::string::npos);
}

TEST(GlbReader, ReadsAFileWithoutMeshes)
{
    auto const read = read_glb(glb_of(std::span<PlacedMesh const>()));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->triangle_count(), 0u);
}

TEST(GlbReader, RefusesDeepNestingAndLoops)
{
    std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
    deep += std::string(200000, '[') + std::string(200000, ']') + "}";
    EXPECT_NE(error_of(glb_of_json(deep)).find("nested too deeply"), std::string::npos);
    EXPECT_NE(error_of(glb_of_json(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],
        "nodes":[{"children":[1]},{"children":[0]}]})"))
                  .find("two parents"),
              std::string::npos);
    EXPECT_NE(error_of(glb_of_json(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[7]}],
        "nodes":[{}]})"))
                  .find("does not exist"),
              std::string::npos);
}

TEST(GlbReader, NeverReachesForOtherFiles)
{
    auto const read = read_glb(glb_of_json(R"({"asset":{"version":"2.0"},
        "buffers":[{"uri":"/etc/hostname","byteLength":4}]})"));
    EXPECT_FALSE(read);
}

// Reading a damaged file must give a valid mesh or an error.
TEST(GlbReader, SurvivesDamagedFiles)
{
    auto plant = mesh::single_axis(2, 5, 1);
    plant.materials.push_back({ .name = "leaf", .kind = Material::Kind::Leaf });
    plant.organ_shapes = { OrganShape { .material = 1 } };
    plant.organs = { Organ { .segment = 0 }, Organ { .segment = 1 } };
    auto const glb = glb_of(mesh::make_mesh(plant), { .textures = GlbOptions::Textures::None });
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, glb.data() + 12, sizeof json_bytes);
    Random random({ .seed = 1 });
    std::size_t read_count = 0;
    for (int i = 0; i < 2500; ++i) {
        std::string bytes = glb;
        // Truncates every fifth file. Below, half of all files get a header with their actual size.
        if (i % 5 == 0)
            bytes.resize(20 + random.next_u32() % (glb.size() - 20));
        for (std::uint32_t k = 0; k <= random.next_u32() % 4; ++k) {
            // In two thirds of the files, only the header and the JSON part are changed. Digits are
            // replaced by digits, since other damage is found at once.
            auto const at = random.next_u32()
                % (i % 3 == 0 ? bytes.size()
                              : std::min<std::size_t>(bytes.size(), 20 + json_bytes));
            bool const digit = bytes[at] >= '0' && bytes[at] <= '9';
            bytes[at] = static_cast<char>(digit ? '0' + random.next_u32() % 10
                                                : random.next_u32() & 0xff);
        }
        auto const size = static_cast<std::uint32_t>(bytes.size());
        if (bytes.size() >= 12 && i % 2 == 0)
            std::memcpy(bytes.data() + 8, &size, sizeof size);
        auto const mesh = read_glb(bytes);
        if (!mesh)
            continue;
        ++read_count;
        for (auto const& surface : mesh->surfaces)
            mesh::expect_sound(surface);
        for (auto const& organ : mesh->organs)
            mesh::expect_sound(organ.prototype);
    }
    EXPECT_GT(read_count, 100u); // Some damaged files must still be readable.
}

} // namespace
} // namespace tractus::exports
