#include "engine/export/obj_writer.h"

#include "engine/mesh/make_mesh.h"
#include "tests/engine/mesh/sample_plants.h"

#include <array>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>

namespace tractus::exports {
namespace {

struct ObjCounts {
    std::size_t objects = 0;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t highest_index = 0;
    double highest_y = 0;
};

ObjCounts count(std::string const& text)
{
    ObjCounts counts;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "o")
            ++counts.objects;
        if (word == "v") {
            ++counts.vertices;
            double x = 0;
            double y = 0;
            words >> x >> y;
            counts.highest_y = std::max(counts.highest_y, y);
        }
        if (word != "f")
            continue;
        ++counts.faces;
        for (std::string corner; words >> corner;)
            counts.highest_index = std::max<std::size_t>(counts.highest_index, std::stoul(corner));
    }
    return counts;
}

TEST(ObjWriter, WritesEveryTriangleOfEveryInstance)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    PlacedMesh const plants[]
        = { { .name = "a b", .mesh = &mesh }, { .position_mm = { 0, 0, 1000 }, .mesh = &mesh } };
    std::ostringstream out;
    ASSERT_TRUE(write_obj(out, plants, "trees.mtl"));
    auto const counts = count(out.str());
    EXPECT_EQ(counts.objects, 2u);
    EXPECT_EQ(counts.faces, 2 * mesh.triangle_count());
    EXPECT_EQ(counts.highest_index, counts.vertices);
    EXPECT_NE(out.str().find("mtllib trees.mtl\n"), std::string::npos);
    EXPECT_NE(out.str().find("o a_b\n"), std::string::npos);
}

TEST(ObjWriter, WritesMetresAndYUp)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::single_axis(4, 10, 10));
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream out;
    ASSERT_TRUE(write_obj(out, std::span(&placed, 1)));
    EXPECT_NEAR(count(out.str()).highest_y, 0.210, 1e-6);
}

// The first texture coordinates and the first face of a text.
struct ObjFirsts {
    std::string texture;
    std::string face;
};

ObjFirsts firsts(mesh::Mesh const& mesh)
{
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream out;
    EXPECT_TRUE(write_obj(out, std::span(&placed, 1)));
    auto const line = [text = out.str()](char const* begin) {
        auto const at = text.find(begin) + 1;
        return text.substr(at, text.find('\n', at) - at);
    };
    return { line("\nvt "), line("\nf ") };
}

TEST(ObjWriter, PicturesStandUprightAndMirroredLeavesAreTurnedRound)
{
    mesh::Mesh mesh;
    mesh.materials = { Material {} };
    auto& organ = mesh.organs.emplace_back();
    organ.prototype.positions_mm = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
    organ.prototype.normals.assign(3, Vec3f::UnitZ());
    organ.prototype.texture_coordinates = { { 0.5f, 0.25f }, { 1, 0 }, { 0, 1 } };
    organ.prototype.indices = { 0, 1, 2 };
    organ.instances = { {} };
    EXPECT_EQ(firsts(mesh).texture, "vt 0.50000 0.75000") << "OBJ counts from the lowest row";
    EXPECT_EQ(firsts(mesh).face, "f 1/1/1 2/2/2 3/3/3");
    organ.instances[0].scale = { -1, 1, 1 };
    EXPECT_EQ(firsts(mesh).face, "f 1/1/1 3/3/3 2/2/2");
}

TEST(ObjWriter, TellsMaterialsOfOneNameApart)
{
    mesh::Mesh const brown = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    mesh::Mesh grey = brown;
    grey.materials[0].base_color = { 0.5f, 0.5f, 0.5f };
    PlacedMesh const plants[] = { { .mesh = &brown }, { .mesh = &grey }, { .mesh = &brown } };
    std::ostringstream materials;
    ASSERT_TRUE(write_mtl(materials, plants));
    EXPECT_NE(materials.str().find("newmtl bark\nKd 0.3100 0.2300 0.1600"), std::string::npos);
    EXPECT_NE(materials.str().find("newmtl bark.2\nKd 0.5000"), std::string::npos);
    std::ostringstream out;
    ASSERT_TRUE(write_obj(out, plants));
    EXPECT_NE(out.str().find("usemtl bark.2\n"), std::string::npos);
}

TEST(ObjWriter, MaterialsNameTheirRoughnessAndPictures)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream materials;
    auto const pictures = write_mtl(materials, std::span(&placed, 1), "tree");
    ASSERT_TRUE(pictures);
    auto const text = materials.str();
    EXPECT_NE(text.find("\nPr 0.9000\nPm 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nmap_Kd tree-bark-color.png\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nmap_Bump tree-bark-normal.png\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nmap_Kd tree-leaf-color.png\n"), std::string::npos) << text;
    ASSERT_EQ(pictures->size(), 3u);
    for (auto const& [name, png] : *pictures) {
        EXPECT_NE(text.find(name), std::string::npos);
        EXPECT_EQ(png.substr(1, 3), "PNG");
    }
}

TEST(ObjWriter, AMaterialThatIsNotUsedTakesNoName)
{
    mesh::Mesh mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    mesh.materials.push_back(mesh.materials[0]);
    mesh.materials[0].base_color = { 0, 0, 1 };
    mesh.surfaces[0].material = 1;
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream materials;
    ASSERT_TRUE(write_mtl(materials, std::span(&placed, 1)));
    EXPECT_NE(materials.str().find("newmtl bark\nKd 0.3100"), std::string::npos);
    EXPECT_EQ(materials.str().find("newmtl bark.2"), std::string::npos);
}

// Materials that differ in nothing but a picture or a number that glTF shows are different.
TEST(ObjWriter, MaterialsThatLookDifferentHaveNamesOfTheirOwn)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    auto const bumpy = [&] {
        auto other = mesh;
        other.materials[0].textures.normal = std::make_shared<TexturePicture const>();
        return other;
    }();
    auto const metallic = [&] {
        auto other = mesh;
        other.materials[0].metalness = 1;
        return other;
    }();
    std::array const placed { PlacedMesh { .mesh = &mesh }, PlacedMesh { .mesh = &bumpy },
                              PlacedMesh { .mesh = &metallic }, PlacedMesh { .mesh = &mesh } };
    std::ostringstream text;
    ASSERT_TRUE(write_obj(text, placed, "tree.mtl"));
    EXPECT_NE(text.str().find("usemtl bark.2\n"), std::string::npos);
    EXPECT_NE(text.str().find("usemtl bark.3\n"), std::string::npos);
    EXPECT_EQ(text.str().find("usemtl bark.4\n"), std::string::npos);
}

TEST(ObjWriter, SaysThatTheStreamFailed)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    auto const result = write_obj(out, std::span(&placed, 1));
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("disk is full"), std::string::npos);
}

} // namespace
} // namespace tractus::exports
