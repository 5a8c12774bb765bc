#include "engine/base/random.h"
#include "engine/export/glb_reader.h"
#include "engine/export/glb_writer.h"
#include "tests/engine/export/glb_of.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/random_plants.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tractus::exports {
namespace {

using Vertices = GlbOptions::Vertices;

GlbOptions with(GlbOptions options, Vertices vertices)
{
    options.vertices = vertices;
    options.textures = GlbOptions::Textures::None;
    return options;
}

rc::Gen<GlbOptions> random_options()
{
    using Options = GlbOptions;
    return rc::gen::apply(
        [](Options::Organs organs, Options::Wind wind) {
            GlbOptions options { .organs = organs };
            options.wind = wind;
            return options;
        },
        rc::gen::element(Options::Organs::Merged, Options::Organs::Instanced,
                         Options::Organs::Nodes),
        rc::gen::element(Options::Wind::Attributes, Options::Wind::TextureCoordinates,
                         Options::Wind::Colours));
}

mesh::Mesh read(std::string const& glb)
{
    auto mesh = read_glb(glb);
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh ? *std::move(mesh) : mesh::Mesh();
}

struct Corner {
    Vec3f position_mm, normal;
    Vec2f texture;
};

// Returns the corners of all triangles, in order. Two meshes with equal corners are equal, even if
// they share vertices in different ways.
std::vector<Corner> corners_of(mesh::Mesh const& mesh)
{
    std::vector<Corner> corners;
    auto const add = [&](mesh::TriangleMesh const& triangles) {
        for (auto const i : triangles.indices)
            corners.push_back({ triangles.positions_mm[i], triangles.normals[i],
                                triangles.texture_coordinates[i] });
    };
    for (auto const& surface : mesh.surfaces)
        add(surface);
    for (auto const& organ : mesh.organs)
        add(organ.prototype);
    return corners;
}

// Describes the difference between the meshes of a compressed and a quantised file; empty if there
// is none.
std::string difference(mesh::Mesh const& compressed, mesh::Mesh const& quantized)
{
    auto const a = corners_of(compressed);
    auto const b = corners_of(quantized);
    if (a.size() != b.size() || compressed.triangle_count() != quantized.triangle_count())
        return "triangles";
    float largest = 1024;
    for (auto const& corner : b)
        largest = std::max(largest, corner.texture.lpNorm<Eigen::Infinity>());
    float const texture_tolerance = 1.01f * largest / 0x1p22f;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].position_mm != b[i].position_mm)
            return "positions";
        if ((a[i].normal - b[i].normal).norm() > 0.035f)
            return "normals";
        if ((a[i].texture - b[i].texture).lpNorm<Eigen::Infinity>() > texture_tolerance)
            return "texture coordinates";
    }
    for (std::size_t i = 0; i < compressed.organs.size(); ++i) {
        auto const& one = compressed.organs[i].instances;
        auto const& other = quantized.organs[i].instances;
        for (std::size_t k = 0; k < one.size(); ++k)
            if (one[k].translation_mm != other[k].translation_mm || one[k].scale != other[k].scale
                || one[k].rotation.coeffs() != other[k].rotation.coeffs())
                return "instances";
    }
    return "";
}

RC_GTEST_PROP(CompressedGlb, ReadsBackAsTheQuantizedOne, ())
{
    auto const plant = *mesh::random_plants();
    auto const mesh = mesh::make_mesh(plant);
    auto const options = *random_options();
    PlacedMesh placed { .mesh = &mesh };
    if (*rc::gen::arbitrary<bool>()) {
        PlantToMesh source { .plant = &plant };
        if (*rc::gen::arbitrary<bool>())
            source.wind = mesh::WindKey {};
        placed.mesh = source;
    }
    auto const write = [&](Vertices vertices) {
        return read(glb_of(std::span(&placed, 1), with(options, vertices)));
    };
    RC_ASSERT(difference(write(Vertices::Compressed), write(Vertices::Quantized)) == "");
}

RC_GTEST_PROP(CompressedGlb, IsTheSameOnAnyNumberOfThreads, ())
{
    auto const plant = *mesh::random_plants();
    auto const options = with(*random_options(), Vertices::Compressed);
    std::vector<PlacedMesh> const placed(
        2, PlacedMesh { .mesh = PlantToMesh { .plant = &plant, .wind = mesh::WindKey {} } });
    auto const write = [&] { return glb_of(placed, options); };
    auto const expected = mesh::on_threads(1, write);
    RC_ASSERT(mesh::on_threads(2, write) == expected);
    RC_ASSERT(mesh::on_threads(5, write) == expected);
}

// A mesh must be written in several pieces with fewer than 70,000 vertices each, whether it is
// given as triangles or as a plant. Its bark has tangents.
TEST(CompressedGlb, IsInPiecesThatStandAlone)
{
    mesh::MeshOptions const fine { .min_sides = 40, .max_sides = 64 };
    auto const plant = mesh::sample_tree(9);
    auto const mesh = mesh::make_mesh(plant, fine);
    for (auto const& source :
         { MeshSource(&mesh), MeshSource(PlantToMesh { .plant = &plant, .options = fine }) }) {
        PlacedMesh const placed { .mesh = source };
        auto const glb
            = glb_of(std::span(&placed, 1), { .vertices = GlbOptions::Vertices::Compressed });
        auto const json = json_of(glb);
        auto const& primitives = json["meshes"][0]["primitives"];
        EXPECT_GT(primitives.size(), 2u);
        for (auto const& primitive : primitives) {
            std::size_t const vertices = primitive["attributes"]["POSITION"];
            EXPECT_LT(json["accessors"][vertices]["count"], 70'000);
        }
        auto const quantized
            = glb_of(std::span(&placed, 1), { .vertices = GlbOptions::Vertices::Quantized });
        EXPECT_EQ(difference(read(glb), read(quantized)), "");
    }
}

TEST(CompressedGlb, LeavesOutVerticesThatNoTriangleHas)
{
    mesh::Mesh mesh;
    mesh.materials = { Material {} };
    auto& surface = mesh.surfaces.emplace_back();
    constexpr std::size_t kVertices = 120'000;
    surface.positions_mm.assign(kVertices, Vec3f::Zero());
    surface.positions_mm[1].x() = 5;
    surface.positions_mm[2].y() = 5;
    surface.normals.assign(kVertices, Vec3f::UnitZ());
    surface.texture_coordinates.assign(kVertices, Vec2f::Zero());
    surface.indices = { 0, 1, 2 };
    auto const compressed = read(glb_of(mesh, with({}, Vertices::Compressed)));
    ASSERT_EQ(compressed.triangle_count(), 1u);
    EXPECT_EQ(compressed.surfaces[0].positions_mm.size(), 3u);
}

TEST(CompressedGlb, HasOneNodeForSomeThousandsOfInstances)
{
    auto plant = mesh::single_axis(2, 5, 1);
    plant.materials.push_back({ .name = "leaf", .kind = Material::Kind::Leaf });
    plant.organ_shapes = { OrganShape { .material = 1 } };
    for (int i = 0; i < 40'000; ++i)
        plant.organs.push_back({ .segment = 0, .position_mm = { 0.1 * i, 0, 0 } });
    PlacedMesh const placed { .mesh = PlantToMesh { .plant = &plant, .wind = mesh::WindKey {} } };
    auto const write = [&](Vertices vertices) {
        return read(glb_of(std::span(&placed, 1), with(kInstanced, vertices)));
    };
    auto const compressed = write(Vertices::Compressed);
    ASSERT_EQ(compressed.organs.size(), 1u);
    EXPECT_EQ(compressed.organs[0].instances.size(), 40'000u);
}

TEST(CompressedGlb, IsSmallerAndSaysWhatItNeeds)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const options = with({}, Vertices::Compressed);
    auto const glb = glb_of(mesh, options);
    auto const quantized = glb_of(mesh, with({}, Vertices::Quantized));
    EXPECT_LT(static_cast<double>(glb.size()), 0.6 * static_cast<double>(quantized.size()));
    auto const json = json_of(glb);
    EXPECT_EQ(json["extensionsRequired"],
              nlohmann::json::parse(R"(["EXT_meshopt_compression","KHR_mesh_quantization"])"));
    ASSERT_EQ(json["buffers"].size(), 2u);
    EXPECT_EQ(json["buffers"][1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
    EXPECT_FALSE(json["buffers"][1].contains("uri"));
    double const bytes = json["buffers"][0]["byteLength"];
    EXPECT_NEAR(static_cast<double>(glb_bytes(mesh, options)), bytes, 0.3 * bytes);
}

// Replaces a word in the JSON part of a .glb file by another word of the same length.
std::string with_word(std::string glb, std::string const& word, std::string const& other)
{
    auto const at = glb.find(word);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(word.size(), other.size());
    return glb.replace(at, word.size(), other);
}

TEST(CompressedGlb, IsRefusedWhereItClaimsWhatCannotBe)
{
    auto const glb
        = glb_of(mesh::make_mesh(mesh::single_axis(1, 1, 1)), with({}, Vertices::Compressed));
    auto const error_with = [&](std::string const& word, std::string const& other) {
        auto const mesh = read_glb(with_word(glb, word, other));
        EXPECT_FALSE(mesh) << other;
        return mesh ? "" : mesh.error().message;
    };
    auto const expect_error
        = [&](std::string const& word, std::string const& other, std::string const& part) {
              auto const error = error_with(word, other);
              EXPECT_NE(error.find(part), std::string::npos) << error;
          };
    expect_error("\"mode\":\"ATTRIBUTES\"", "\"mode\":\"SOMETHINGS\"", "mode or filter");
    expect_error("\"filter\":\"OCTAHEDRAL\"", "\"filter\":\"QUATERNION\"", "does not fit");
    expect_error("\"byteStride\":8,\"count\"", "\"byteStride\":7,\"count\"", "stride");

    expect_error("{\"buffer\":0,\"byteOffset\":0,", "{\"buffer\":0,\"byteOffset\":9,", "");
    expect_error("{\"buffer\":0,", "{\"buffer\":7,", "has no buffer");
    expect_error("\"mode\":\"INDICES\"", "\"mode\":\"INDICEX\"", "mode or filter");
}

// Reading a damaged file must give a valid mesh or an error.
TEST(CompressedGlb, IsReadSafelyWhereItIsDamaged)
{
    auto const glb = glb_of(mesh::make_mesh(mesh::sample_tree(2)), with({}, Vertices::Compressed));
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, glb.data() + 12, sizeof json_bytes);
    Random random({ .seed = 1 });
    std::size_t read_count = 0;
    for (int i = 0; i < 600; ++i) {
        std::string bytes = glb;
        for (std::uint32_t k = 0; k <= random.next_u32() % 4; ++k) {
            auto const at = random.next_u32() % (i % 2 == 0 ? bytes.size() : 20 + json_bytes);
            bool const digit = bytes[at] >= '0' && bytes[at] <= '9';
            bytes[at] = static_cast<char>(digit ? '0' + random.next_u32() % 10
                                                : random.next_u32() & 0xff);
        }
        auto const mesh = read_glb(bytes);
        if (!mesh)
            continue;
        ++read_count;
        for (auto const& surface : mesh->surfaces)
            mesh::expect_sound(surface);
    }
    EXPECT_GT(read_count, 20u);
}

} // namespace
} // namespace tractus::exports
