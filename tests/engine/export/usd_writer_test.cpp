#include "engine/export/usd_writer.h"

#include "engine/export/obj_writer.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "tests/engine/mesh/random_plants.h"

#include <array>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace tractus::exports {
namespace {

struct WrittenUsd {
    std::string text;
    std::vector<PictureFile> pictures;
};

WrittenUsd usda_of(mesh::Mesh const& mesh, UsdOptions const& options = {},
                   std::string_view stem = "tree")
{
    PlacedMesh const placed { .name = "tree", .mesh = &mesh };
    std::ostringstream out;
    auto pictures = write_usda(out, { &placed, 1 }, stem, options);
    EXPECT_TRUE(pictures);
    return { out.str(), std::move(*pictures) };
}

std::size_t count(std::string const& text, std::string const& part)
{
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

// The numbers of each array with the given declaration, in the order of the text.
std::vector<std::vector<double>> arrays(std::string const& text, std::string const& declaration)
{
    std::vector<std::vector<double>> found;
    for (auto at = text.find(declaration + " = ["); at != std::string::npos;
         at = text.find(declaration + " = [", at + 1)) {
        auto const begin = at + declaration.size() + 4;
        auto list = text.substr(begin, text.find(']', begin) - begin);
        for (auto& c : list)
            if (c == '(' || c == ')' || c == ',')
                c = ' ';
        auto& array = found.emplace_back();
        char* end = nullptr;
        for (char const* at_number = list.c_str();; at_number = end) {
            double const number = std::strtod(at_number, &end);
            if (end == at_number)
                break;
            array.push_back(number);
        }
    }
    return found;
}

Vec3 vector_at(std::vector<double> const& numbers, std::size_t i)
{
    return { numbers.at(3 * i), numbers.at(3 * i + 1), numbers.at(3 * i + 2) };
}

// The positions of a plant's vertices in its .obj file.
std::vector<Vec3> positions_in_obj(mesh::Mesh const& mesh)
{
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream out;
    EXPECT_TRUE(write_obj(out, { &placed, 1 }));
    std::istringstream lines(out.str());
    std::vector<Vec3> found;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("v ")) {
            auto& at = found.emplace_back();
            char* end = line.data() + 1;
            for (int axis = 0; axis < 3; ++axis)
                at[axis] = std::strtod(end, &end);
        }
    return found;
}

// The positions of all vertices of a .usda file, those of instances at their places.
std::vector<Vec3> positions_in_usda(std::string const& text)
{
    auto const instancer = text.find("def PointInstancer");
    std::vector<Vec3> found;
    for (auto const& points : arrays(text.substr(0, instancer), "point3f[] points"))
        for (std::size_t i = 0; 3 * i < points.size(); ++i)
            found.push_back(vector_at(points, i));
    if (instancer == std::string::npos)
        return found;
    auto const prototypes = arrays(text.substr(instancer), "point3f[] points");
    auto const numbers = arrays(text, "int[] protoIndices").at(0);
    auto const positions = arrays(text, "point3f[] positions").at(0);
    auto const rotations = arrays(text, "quatf[] orientationsf").at(0);
    auto const scales = arrays(text, "float3[] scales").at(0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Quat const turn(rotations.at(4 * i), rotations.at(4 * i + 1), rotations.at(4 * i + 2),
                        rotations.at(4 * i + 3));
        auto const& points = prototypes.at(static_cast<std::size_t>(numbers[i]));
        for (std::size_t k = 0; 3 * k < points.size(); ++k)
            found.push_back(vector_at(positions, i)
                            + turn * vector_at(scales, i).cwiseProduct(vector_at(points, k)));
    }
    return found;
}

double farthest_apart(std::vector<Vec3> const& a, std::vector<Vec3> const& b)
{
    EXPECT_EQ(a.size(), b.size());
    double most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        most = std::max(most, (a[i] - b[i]).norm());
    return most;
}

TEST(UsdWriter, StatesUnitAndAxisAndHasAPrimForEachPlant)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    PlacedMesh const plants[] = {
        { .name = "a b", .mesh = &mesh },
        { .name = "a b", .position_mm = { 0, 2000, 1000 }, .rotation_rad = kPi / 2, .mesh = &mesh },
        { .name = "2nd", .mesh = &mesh }
    };
    std::ostringstream out;
    ASSERT_TRUE(write_usda(out, plants));
    auto const text = out.str();
    EXPECT_TRUE(text.starts_with("#usda 1.0\n"));
    EXPECT_NE(text.find("metersPerUnit = 1\n"), std::string::npos);
    EXPECT_NE(text.find("upAxis = \"Y\"\n"), std::string::npos);
    for (char const* const name : { "\"a_b\"", "\"a_b_2\"", "\"_2nd\"" })
        EXPECT_EQ(count(text, std::string("def Xform ") + name), 1u) << name;
    EXPECT_NE(text.find("xformOp:translate = (0, 1, -2)"), std::string::npos);
    EXPECT_NE(text.find("xformOp:rotateY = 90\n"), std::string::npos);
    EXPECT_EQ(count(text, "def Material \"bark\""), 1u) << "equal materials are written once";
    EXPECT_EQ(count(text, "{"), count(text, "}"));
    EXPECT_EQ(count(text, "("), count(text, ")"));
}

TEST(UsdWriter, InstancedLeavesStandWhereTheMergedOnesAre)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto const plant = seed == 1 ? mesh::sample_tree(1) : mesh::random_plant(seed, 6);
        auto mesh = mesh::make_mesh(plant);
        for (auto& material : mesh.materials)
            material.kind = Material::Kind::Solid; // Pictures of bark would take a minute.
        auto const expected = positions_in_obj(mesh);
        using Organs = UsdOptions::Organs;
        for (auto const organs : { Organs::Instanced, Organs::Merged })
            EXPECT_LT(farthest_apart(positions_in_usda(usda_of(mesh, { organs }).text), expected),
                      1e-5)
                << seed;
    }
}

TEST(UsdWriter, AMirroredLeafHasAMirroredPrototype)
{
    auto plant = mesh::sample_tree(1);
    plant.organs.resize(2);
    plant.organs[1].scale = { 0.5f, -2, 1 };
    auto const mesh = mesh::make_mesh(plant);
    auto const text = usda_of(mesh).text;
    EXPECT_LT(farthest_apart(positions_in_usda(text), positions_in_obj(mesh)), 1e-5);
    auto const scales = arrays(text, "float3[] scales");
    for (std::size_t i = 0; i + 2 < scales.at(0).size(); i += 3)
        EXPECT_GT(scales[0][i] * scales[0][i + 1] * scales[0][i + 2], 0) << "no copy is mirrored";
    auto const indices
        = arrays(text.substr(text.find("def PointInstancer")), "int[] faceVertexIndices");
    ASSERT_EQ(indices.size(), 2u);
    EXPECT_EQ(indices[0][1], indices[1][2]) << "its triangles are reversed";
}

TEST(UsdWriter, CountsAgreeWithTheMesh)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const text = usda_of(mesh).text;
    EXPECT_EQ(arrays(text, "int[] protoIndices").at(0).size(), mesh.organs[0].instances.size());
    auto const merged = usda_of(mesh, { UsdOptions::Organs::Merged }).text;
    std::size_t triangles = 0;
    for (auto const& counts : arrays(merged, "int[] faceVertexCounts"))
        triangles += counts.size();
    EXPECT_EQ(triangles, mesh.triangle_count());
    auto const points = arrays(merged, "point3f[] points");
    auto const normals = arrays(merged, "normal3f[] normals");
    auto const st = arrays(merged, "texCoord2f[] primvars:st");
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(normals.at(i).size(), points[i].size());
        EXPECT_EQ(3 * st.at(i).size(), 2 * points[i].size());
    }
}

TEST(UsdWriter, MaterialsReferToTheirPictures)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const [text, pictures] = usda_of(mesh);
    EXPECT_NE(text.find("asset inputs:file = @./tree-bark-color.png@"), std::string::npos);
    EXPECT_NE(text.find("asset inputs:file = @./tree-bark-normal.png@"), std::string::npos);
    EXPECT_NE(text.find("asset inputs:file = @./tree-leaf-color.png@"), std::string::npos);
    EXPECT_NE(text.find("float inputs:roughness = 0.6"), std::string::npos);
    EXPECT_EQ(count(text, "uniform bool doubleSided = 1"), 1u) << "of leaves alone";
    // Occlusion and roughness of bark are channels of one picture.
    EXPECT_EQ(pictures.size(), 4u);
    for (auto const& [name, bytes] : pictures) {
        EXPECT_TRUE(name.starts_with("tree-"));
        EXPECT_EQ(bytes.substr(1, 3), "PNG");
        EXPECT_NE(text.find(name), std::string::npos);
    }
    auto const [plain, none] = usda_of(mesh, {}, "");
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(plain.find("UsdUVTexture"), std::string::npos);
}

TEST(UsdWriter, ACutOutIsMasked)
{
    auto mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto& textures = mesh.materials[1].textures;
    textures.base_color = std::make_shared<TexturePicture const>(
        TexturePicture { "\xff\xd8 a photo", TexturePicture::Edges::Clamp });
    textures.alpha = MaterialTextures::Alpha::Mask;
    textures.color = MaterialTextures::Color::Replaced;
    auto const [text, pictures] = usda_of(mesh);
    EXPECT_EQ(count(text, "float inputs:opacityThreshold = 0.5"), 1u);
    EXPECT_EQ(count(text, "float inputs:opacity.connect = "), 1u);
    EXPECT_NE(text.find("@./tree-leaf-color.jpg@"), std::string::npos);
    EXPECT_NE(text.find("inputs:wrapS = \"clamp\""), std::string::npos);
}

TEST(UsdWriter, SaysThatTheStreamFailed)
{
    auto const mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    PlacedMesh const placed { .mesh = &mesh };
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    auto const result = write_usda(out, { &placed, 1 });
    ASSERT_FALSE(result);
    EXPECT_NE(result.error().message.find("disk is full"), std::string::npos);
}

} // namespace
} // namespace tractus::exports
