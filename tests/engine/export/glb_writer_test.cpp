#include "engine/export/glb_writer.h"

#include "engine/export/glb_reader.h"
#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "tests/engine/export/glb_of.h"
#include "tests/engine/mesh/sample_plants.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace tractus::exports {
namespace {

std::uint32_t u32_at(std::string const& bytes, std::size_t offset)
{
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

// A stream that accepts some bytes and then fails, like a full disk.
class FullDisk : public std::stringbuf {
public:
    explicit FullDisk(std::streamsize room)
        : room_(room)
    {
    }

protected:
    std::streamsize xsputn(char const* bytes, std::streamsize count) override
    {
        if (count > room_)
            return 0;
        room_ -= count;
        return std::stringbuf::xsputn(bytes, count);
    }

private:
    std::streamsize room_;
};

TEST(GlbWriter, HeadersSayTheSizes)
{
    auto const glb = glb_of(mesh::make_mesh(mesh::sample_tree(1)));
    EXPECT_EQ(glb.substr(0, 4), "glTF");
    EXPECT_EQ(u32_at(glb, 4), 2u);
    EXPECT_EQ(u32_at(glb, 8), glb.size());
    auto const json_bytes = u32_at(glb, 12);
    EXPECT_EQ(glb.substr(16, 4), "JSON");
    EXPECT_EQ(json_bytes % 4, 0u);
    EXPECT_EQ(u32_at(glb, 20 + json_bytes), glb.size() - 28 - json_bytes);
    EXPECT_EQ(json_of(glb)["buffers"][0]["byteLength"], glb.size() - 28 - json_bytes);
}

TEST(GlbWriter, WritesMetresAndYUp)
{
    // The trunk is 200 mm high, plus a dome with a radius of 10 mm.
    auto const json = json_of(glb_of(mesh::make_mesh(mesh::single_axis(4, 10, 10))));
    auto const& positions = json["accessors"][0];
    EXPECT_NEAR(positions["min"][1].get<double>(), 0, 1e-9);
    EXPECT_NEAR(positions["max"][1].get<double>(), 0.210, 1e-6);
    EXPECT_NEAR(positions["max"][0].get<double>(), 0.010, 1e-6);
}

TEST(GlbWriter, WritesTheSameBytesAgain)
{
    auto const plant = mesh::sample_tree(2);
    EXPECT_EQ(glb_of(mesh::make_mesh(plant)), glb_of(mesh::make_mesh(plant)));
}

// Returns the numbers of an accessor with float components.
std::vector<float> floats_of(std::string const& glb, std::size_t accessor, std::size_t components)
{
    auto const json = json_of(glb);
    auto const& numbers = json["accessors"][accessor];
    auto const& view = json["bufferViews"][numbers["bufferView"].get<std::size_t>()];
    std::vector<float> values(numbers["count"].get<std::size_t>() * components);
    std::memcpy(values.data(),
                glb.data() + 28 + u32_at(glb, 12) + view["byteOffset"].get<std::size_t>(),
                values.size() * sizeof(float));
    return values;
}

TEST(GlbWriter, EveryPlantIsOneMeshThatAnyReaderKnows)
{
    auto const plant = mesh::sample_tree(1);
    auto const mesh = mesh::make_mesh(plant);
    PlacedMesh const plants[] = { { .mesh = &mesh }, { .mesh = PlantToMesh { .plant = &plant } } };
    auto const glb = glb_of(plants);
    auto const json = json_of(glb);
    EXPECT_FALSE(json.contains("extensionsRequired"));
    EXPECT_EQ(json["extensionsUsed"], nlohmann::json({ "KHR_materials_diffuse_transmission" }));
    EXPECT_EQ(json["nodes"].size(), 2u);
    EXPECT_EQ(json["meshes"].size(), 2u);
    EXPECT_EQ(json["materials"].size(), 2u);
    for (auto const& made : json["meshes"]) {
        // One primitive is the bark, the other one the leaves.
        ASSERT_EQ(made["primitives"].size(), 2u);
        std::size_t indices = 0;
        for (auto const& primitive : made["primitives"])
            indices += json["accessors"][primitive["indices"].get<std::size_t>()]["count"]
                           .get<std::size_t>();
        EXPECT_EQ(indices / 3, mesh.triangle_count());
    }
}

TEST(GlbWriter, MergedOrgansThatAreMirroredOrFlatFaceOutwards)
{
    auto plant = mesh::single_axis(1, 10, 2);
    plant.materials.push_back({ .name = "fruit", .kind = Material::Kind::Solid });
    plant.organ_shapes = { { .name = "ball",
                             .kind = OrganShape::Kind::Ball,
                             .material = static_cast<MaterialId>(plant.materials.size() - 1),
                             .length_mm = 10,
                             .width_mm = 10 } };
    plant.organs
        = { { .scale = { 2, 1, 1 } }, { .scale = { -2, 1, 3 } }, { .scale = { 1, 0, 1 } } };
    auto const read = read_glb(glb_of(mesh::make_mesh(plant)));
    ASSERT_TRUE(read) << read.error().message;
    auto const& fruit = read->surfaces.back();
    auto const third = fruit.triangle_count() / 3;
    for (std::size_t t = 0; t < fruit.triangle_count(); ++t) {
        Vec3f corners[3];
        Vec3f normal = Vec3f::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            auto const i = fruit.indices[3 * t + k];
            corners[k] = fruit.positions_mm[i];
            normal += fruit.normals[i];
            EXPECT_NEAR(fruit.normals[i].norm(), 1, 1e-4);
        }
        Vec3f const facing = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        if (t < 2 * third) {
            EXPECT_GT(facing.dot(normal), 0) << t;
        }
    }
}

TEST(GlbWriter, MergedOrgansMoveInTheWindWithTheirBranch)
{
    auto const plant = mesh::sample_tree(1);
    PlacedMesh const placed { .mesh
                              = PlantToMesh { .plant = &plant, .wind = mesh::WindKey { 5, 6 } } };
    auto const glb = glb_of(std::span(&placed, 1));
    auto const json = json_of(glb);
    auto const& attributes = json["meshes"][0]["primitives"][1]["attributes"];
    auto const pivots = floats_of(glb, attributes["_PIVOT"], 3);
    auto const levels = floats_of(glb, attributes["_LEVEL"], 1);
    auto const of_one = mesh::make_prototype(plant, 0).positions_mm.size();
    ASSERT_EQ(levels.size(), of_one * plant.organs.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        auto const& axis = plant.axes[axis_of(plant, plant.organs[i / of_one].segment)];
        EXPECT_EQ(levels[i], static_cast<float>(axis.order));
        EXPECT_NEAR(pivots[3 * i + 1], 0.001 * plant.positions(axis)[0].z(), 1e-5);
    }
}

TEST(GlbWriter, QuantizedMergedOrgansAreNearTheRealOnes)
{
    auto const plant = mesh::sample_tree(1);
    PlacedMesh const placed { .mesh = PlantToMesh { .plant = &plant } };
    auto const exact = read_glb(glb_of(std::span(&placed, 1)));
    auto const bytes
        = glb_of(std::span(&placed, 1), { .vertices = GlbOptions::Vertices::Quantized });
    EXPECT_EQ(json_of(bytes)["extensionsRequired"], nlohmann::json({ "KHR_mesh_quantization" }));
    auto const rounded = read_glb(bytes);
    ASSERT_TRUE(exact && rounded);
    auto const size_mm = (mesh::bounds(*exact).max_mm - mesh::bounds(*exact).min_mm).maxCoeff();
    auto const& a = exact->surfaces[1].positions_mm;
    auto const& b = rounded->surfaces[1].positions_mm;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_LT((a[i] - b[i]).norm(), 2 * size_mm / 65532);
}

TEST(GlbWriter, SaysBeforeItWritesWhatItWillTake)
{
    auto const plant = mesh::sample_tree(1);
    PlacedMesh const placed { .mesh = PlantToMesh { .plant = &plant } };
    std::vector<PlacedMesh> const plants { placed, placed };
    std::ostringstream out;
    GlbSummary expected;
    GlbOptions options { .textures = GlbOptions::Textures::None };
    options.before_writing = [&](GlbSummary const& told) {
        EXPECT_TRUE(out.str().empty());
        expected = told;
    };
    auto const summary = write_glb(out, plants, options);
    ASSERT_TRUE(summary);
    EXPECT_EQ(expected.triangles, summary->triangles);
    EXPECT_NEAR(static_cast<double>(expected.bytes), static_cast<double>(summary->bytes),
                0.05 * static_cast<double>(summary->bytes));
}

TEST(GlbWriter, SharesWhatPlantsHaveInCommon)
{
    mesh::Mesh const meshes[]
        = { mesh::make_mesh(mesh::sample_tree(1)), mesh::make_mesh(mesh::sample_tree(2)),
            mesh::make_mesh(mesh::sample_tree(3)) };
    PlacedMesh const plants[]
        = { { .name = "a", .mesh = &meshes[0] },
            { .name = "b", .position_mm = { 3000, 0, 0 }, .rotation_rad = 1, .mesh = &meshes[1] },
            { .name = "c", .position_mm = { 0, 2000, 0 }, .mesh = &meshes[2] } };
    auto const json = json_of(glb_of(plants, kInstanced));
    EXPECT_EQ(json["materials"].size(), 2u);
    EXPECT_EQ(json["images"].size(), 4u);
    EXPECT_EQ(json["meshes"].size(), 4u); // Three plants and one leaf.
    EXPECT_EQ(json["scenes"][0]["nodes"].size(), 3u);
    auto const& last = json["nodes"][json["scenes"][0]["nodes"][2].get<std::size_t>()];
    EXPECT_EQ(last["name"], "c");
    // In glTF, the direction away from the user is -z.
    EXPECT_DOUBLE_EQ(last["translation"][2], -2);
}

TEST(GlbWriter, MakesPlantsOneAtATime)
{
    int alive = 0;
    std::vector<PlacedMesh> plants(5);
    for (std::size_t i = 0; i < plants.size(); ++i)
        plants[i].mesh = [&, i] {
            ++alive;
            return mesh::make_mesh(mesh::sample_tree(i));
        };
    auto const glb = glb_of(plants);
    EXPECT_EQ(alive, 5);
    EXPECT_EQ(json_of(glb)["scenes"][0]["nodes"].size(), 5u);
}

TEST(GlbWriter, TriesAgainWhenLaterPlantsNeedMoreJsonThanTheFirst)
{
    mesh::Mesh const small = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    mesh::Mesh large = mesh::make_mesh(mesh::sample_tree(1));
    for (int i = 0; i < 20; ++i) { // Twenty organ shapes, all different.
        large.organs.push_back(large.organs[0]);
        large.organs.back().prototype.positions_mm[0].x() += static_cast<float>(i + 1);
    }
    PlacedMesh const plants[] = { { .mesh = &small }, { .mesh = &large } };
    auto const json = json_of(glb_of(plants, kInstanced));
    EXPECT_EQ(json["meshes"].size(), 1 + 1 + 21u);
}

TEST(GlbWriter, CoarserLevelsStandBesideTheScene)
{
    auto const fine = mesh::make_mesh(mesh::sample_tree(1));
    auto const coarse = mesh::make_mesh(mesh::single_axis(4, 10, 2));
    PlacedMesh placed { .name = "tree",
                        .position_mm = { 1000, 0, 0 },
                        .mesh = &fine,
                        .details = { { &coarse, 0.05 },
                                     { std::function<Billboard()>([] {
                                           return Billboard { "picture", { 0, 0, 500 }, 1000 };
                                       }),
                                       0 } },
                        .min_coverage = 0.2 };
    std::vector<PlacedMesh> const plants { placed, placed };
    auto const json = json_of(glb_of(plants, kInstanced));
    auto const& roots = json["scenes"][0]["nodes"];
    ASSERT_EQ(roots.size(), 2u);
    for (auto const& root : roots) {
        auto const& node = json["nodes"][root.get<std::size_t>()];
        EXPECT_EQ(node["name"], "tree");
        EXPECT_EQ(node["extras"]["MSFT_screencoverage"], nlohmann::json({ 0.2, 0.05, 0.0 }));
        auto const& levels = node["extensions"]["MSFT_lod"]["ids"];
        ASSERT_EQ(levels.size(), 2u);
        for (auto const& level : levels) { // Each level must have the position of the plant.
            auto const& coarser = json["nodes"][level.get<std::size_t>()];
            EXPECT_EQ(coarser["translation"], node["translation"]);
        }
        auto const& far = json["nodes"][levels[1].get<std::size_t>()];
        EXPECT_EQ(far["name"], "tree level 2");
        auto const& primitive = json["meshes"][far["mesh"].get<std::size_t>()]["primitives"][0];
        EXPECT_EQ(json["accessors"][primitive["indices"].get<std::size_t>()]["count"],
                  3 * 2 * kBillboardViews);
        auto const& material = json["materials"][primitive["material"].get<std::size_t>()];
        EXPECT_EQ(material["alphaMode"], "MASK");
    }
    EXPECT_EQ(json["extensionsUsed"].size(), 4u);
    // The only required extension is that for instanced leaves.
    EXPECT_EQ(json["extensionsRequired"].size(), 1u);
}

TEST(GlbWriter, WritesWhatTheWindNeeds)
{
    auto const plant = mesh::sample_tree(1);
    PlacedMesh const placed { .mesh
                              = PlantToMesh { .plant = &plant, .wind = mesh::WindKey { 5, 6 } } };
    auto const glb = glb_of(
        std::span(&placed, 1),
        { .organs = GlbOptions::Organs::Instanced, .vertices = GlbOptions::Vertices::Quantized });
    auto const json = json_of(glb);
    nlohmann::json attributes; // Vertex attributes of the tubes.
    nlohmann::json of_leaves;  // Attributes of the instanced leaves.
    for (auto const& mesh : json["meshes"])
        if (mesh["primitives"][0]["attributes"].contains("_BEND"))
            attributes = mesh["primitives"][0]["attributes"];
    for (auto const& node : json["nodes"])
        if (node.contains("extensions"))
            of_leaves = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    for (auto const* const name : { "_PIVOT", "_AXIS", "_LEVEL", "_PHASE", "_BEND" }) {
        ASSERT_TRUE(attributes.contains(name)) << name;
        ASSERT_TRUE(of_leaves.contains(name)) << name;
    }
    auto const count = json["accessors"][attributes["POSITION"].get<std::size_t>()]["count"];
    auto const bends = floats_of(glb, attributes["_BEND"], 1);
    EXPECT_EQ(bends.size(), count);
    EXPECT_EQ(*std::min_element(bends.begin(), bends.end()), 0);
    EXPECT_EQ(*std::max_element(bends.begin(), bends.end()), 1);

    // The pivot of a leaf is the base of its branch, in metres with +y upwards.
    auto const pivots = floats_of(glb, of_leaves["_PIVOT"], 3);
    auto const levels = floats_of(glb, of_leaves["_LEVEL"], 1);
    ASSERT_EQ(levels.size(), plant.organs.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        auto const& axis = plant.axes[axis_of(plant, plant.organs[i].segment)];
        Vec3 const base = plant.positions(axis)[0];
        EXPECT_EQ(levels[i], static_cast<float>(axis.order));
        EXPECT_NEAR(pivots[3 * i], 0.001 * base.x(), 1e-5);
        EXPECT_NEAR(pivots[3 * i + 1], 0.001 * base.z(), 1e-5);
        EXPECT_NEAR(pivots[3 * i + 2], -0.001 * base.y(), 1e-5);
    }
}

TEST(GlbWriter, WritesWindWhereAnEngineLooksForIt)
{
    auto const plant = mesh::single_axis(4, 10, 5);
    PlacedMesh const windy { .mesh = PlantToMesh { .plant = &plant, .wind = mesh::WindKey {} } };
    auto const attributes = [&](GlbOptions const& options) {
        auto const json = json_of(glb_of(std::span(&windy, 1), options));
        return json["meshes"][0]["primitives"][0]["attributes"];
    };
    auto const uv = attributes({ .wind = GlbOptions::Wind::TextureCoordinates });
    for (auto const* const name : { "TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_4" })
        EXPECT_TRUE(uv.contains(name)) << name;
    EXPECT_TRUE(attributes({ .wind = GlbOptions::Wind::Colours }).contains("COLOR_0"));
    PlacedMesh const calm { .mesh = PlantToMesh { .plant = &plant } };
    auto const json = json_of(glb_of(std::span(&calm, 1)));
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["attributes"].size(), 4u);
}

TEST(GlbWriter, OrgansThatAreNodesHaveTheWindInTheirExtras)
{
    auto const plant = mesh::sample_tree(1);
    PlacedMesh const placed { .mesh
                              = PlantToMesh { .plant = &plant, .wind = mesh::WindKey { 5, 6 } } };
    auto const glb = glb_of(std::span(&placed, 1), kInstanced);
    auto const nodes
        = json_of(glb_of(std::span(&placed, 1), { .organs = GlbOptions::Organs::Nodes }));
    auto const json = json_of(glb);
    // Attributes of the leaves in `glb`, where they are instances and not nodes.
    nlohmann::json attributes;
    for (auto const& node : json["nodes"])
        if (node.contains("extensions"))
            attributes = node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    auto const pivots = floats_of(glb, attributes["_PIVOT"], 3);
    auto const phases = floats_of(glb, attributes["_PHASE"], 1);
    std::size_t leaf = 0;
    for (auto const& node : nodes["nodes"]) {
        if (!node.contains("extras"))
            continue;
        ASSERT_LT(leaf, phases.size());
        auto const& wind = node["extras"];
        EXPECT_FLOAT_EQ(wind["_PIVOT"][1].get<float>(), pivots[3 * leaf + 1]);
        EXPECT_FLOAT_EQ(wind["_PHASE"].get<float>(), phases[leaf]);
        for (auto const* const name : { "_AXIS", "_LEVEL", "_BEND" })
            EXPECT_TRUE(wind.contains(name)) << name;
        ++leaf;
    }
    EXPECT_EQ(leaf, plant.organs.size());
}

TEST(GlbWriter, WritesANodePerOrganWhenAsked)
{
    auto const plant = mesh::sample_tree(1);
    auto const json
        = json_of(glb_of(mesh::make_mesh(plant), { .organs = GlbOptions::Organs::Nodes }));
    EXPECT_EQ(json["nodes"].size(), plant.organs.size() + 1);
    EXPECT_EQ(json["extensionsUsed"], nlohmann::json({ "KHR_materials_diffuse_transmission" }));
}

TEST(GlbWriter, BarkHasItsFurrowsColourReliefAndOcclusion)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const json = json_of(glb_of(mesh));
    auto const& bark = json["materials"][0];
    ASSERT_TRUE(bark.contains("occlusionTexture"));
    EXPECT_EQ(bark["occlusionTexture"], bark["pbrMetallicRoughness"]["metallicRoughnessTexture"]);
    EXPECT_TRUE(bark.contains("normalTexture"));
    EXPECT_EQ(json["images"].size(), 4u); // Three images of the bark, and one of the leaf's veins.
    EXPECT_FALSE(json["materials"][1].contains("normalTexture"));
    for (auto const& primitive : json["meshes"][0]["primitives"])
        EXPECT_EQ(primitive["attributes"].contains("TANGENT"), primitive["material"] == 0);
    // If no pictures are written, no tangents are needed.
    auto const plain = json_of(glb_of(mesh, { .textures = GlbOptions::Textures::None }));
    EXPECT_FALSE(plain["materials"][0].contains("normalTexture"));
    EXPECT_FALSE(plain["meshes"][0]["primitives"][0]["attributes"].contains("TANGENT"));
}

TEST(GlbWriter, WritesTheTexturesOfAMaterial)
{
    auto mesh = mesh::make_mesh(mesh::sample_tree(1));
    auto const picture = [](char const* png) {
        return std::make_shared<TexturePicture const>(
            TexturePicture { png, TexturePicture::Edges::Clamp });
    };
    auto& leaf = mesh.materials[1];
    leaf.textures = { .base_color = picture("colour"),
                      .normal = picture("normal"),
                      .occlusion = picture("roughness"),
                      .roughness = picture("roughness"),
                      .translucency = picture("translucency"),
                      .alpha = MaterialTextures::Alpha::Mask };
    auto const json = json_of(glb_of(mesh));
    auto const& written = json["materials"][1];
    EXPECT_EQ(written["alphaMode"], "MASK");
    EXPECT_EQ(written["doubleSided"], true);
    std::set<int> const indices {
        written["pbrMetallicRoughness"]["baseColorTexture"]["index"].get<int>(),
        written["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"].get<int>(),
        written["normalTexture"]["index"].get<int>(),
        written["extensions"]["KHR_materials_diffuse_transmission"]["diffuseTransmissionTexture"]
               ["index"]
                   .get<int>()
    };
    EXPECT_EQ(indices.size(), 4u);
    EXPECT_FALSE(json.contains("extensionsRequired"));
}

TEST(GlbWriter, LeavesPassLightWithoutAPicture)
{
    auto mesh = mesh::make_mesh(mesh::sample_tree(1));
    mesh.materials[0].translucency = 0.9f; // Bark passes no light, whatever its translucency is.
    mesh.materials[1].translucency = 0.5f;
    auto const json = json_of(glb_of(mesh, { .textures = GlbOptions::Textures::None }));
    EXPECT_FALSE(json["materials"][0].contains("extensions"));
    EXPECT_EQ(json["materials"][1]["extensions"]["KHR_materials_diffuse_transmission"],
              nlohmann::json({ { "diffuseTransmissionFactor", 0.5 } }));
    EXPECT_FALSE(json.contains("extensionsRequired"));
    mesh.materials[1].translucency = 0;
    EXPECT_FALSE(json_of(glb_of(mesh)).contains("extensionsUsed"));
}

TEST(GlbWriter, LeavesAreDoubleSidedAndColoursLinear)
{
    // The colours are written without pictures, since they would otherwise be lightened to
    // compensate for dark pictures.
    auto const json = json_of(
        glb_of(mesh::make_mesh(mesh::sample_tree(1)), { .textures = GlbOptions::Textures::None }));
    for (auto const& material : json["materials"]) {
        bool const leaf = material["name"] == "leaf";
        EXPECT_EQ(material.value("doubleSided", false), leaf);
        if (leaf) {
            EXPECT_NEAR(material["pbrMetallicRoughness"]["baseColorFactor"][1].get<double>(),
                        0.2140, 1e-3);
        }
    }
}

TEST(GlbWriter, WritesAFileWithoutPlants)
{
    auto const json = json_of(glb_of(std::span<PlacedMesh const>()));
    EXPECT_EQ(json["asset"]["version"], "2.0");
    EXPECT_FALSE(json.contains("buffers"));
}

TEST(GlbWriter, QuotesNamesAndReplacesWhatIsNoUtf8)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    PlacedMesh const placed { .name = "a \"b\"\n\xff", .mesh = &mesh };
    EXPECT_EQ(json_of(glb_of(std::span(&placed, 1)))["nodes"][0]["name"], "a \"b\"\n\xEF\xBF\xBD");
}

TEST(GlbWriter, SaysThatTheDiskIsFull)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    PlacedMesh const placed { .mesh = &mesh };
    for (std::streamsize const room : { 0, 1000, 100000 }) {
        FullDisk disk(room);
        std::ostream out(&disk);
        auto const summary = write_glb(out, std::span(&placed, 1));
        ASSERT_FALSE(summary);
        EXPECT_NE(summary.error().message.find("cannot write"), std::string::npos);
    }
}

TEST(GlbWriter, RefusesAFileBeyondFourGibibytesBeforeItStarts)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    std::vector<PlacedMesh> const plants(20000, PlacedMesh { .mesh = &mesh });
    std::ostringstream out;
    auto const summary = write_glb(out, plants);
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().message.find("at most 4"), std::string::npos)
        << summary.error().message;
    EXPECT_TRUE(out.str().empty());
}

TEST(GlbWriter, RefusesMorePlantsThanAreLikelyToFitBeforeItStarts)
{
    auto const plant = mesh::sample_tree(1);
    std::vector<PlacedMesh> const plants(
        20000, PlacedMesh { .mesh = PlantToMesh { .plant = [&] { return plant; } } });
    std::ostringstream out;
    auto const summary = write_glb(out, plants);
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().message.find("take about"), std::string::npos)
        << summary.error().message;
    EXPECT_TRUE(out.str().empty());
}

TEST(GlbWriter, QuantizedFilesAreSmallerAndSayWhatTheyNeed)
{
    mesh::Mesh const mesh = mesh::make_mesh(mesh::sample_tree(1));
    GlbOptions const quantized { .organs = GlbOptions::Organs::Instanced,
                                 .textures = GlbOptions::Textures::None,
                                 .vertices = GlbOptions::Vertices::Quantized };
    auto const glb = glb_of(mesh, quantized);
    EXPECT_LT(glb.size(), 0.8 * static_cast<double>(glb_of(mesh, kInstanced).size()));
    auto const json = json_of(glb);
    EXPECT_EQ(json["extensionsRequired"],
              nlohmann::json::parse(R"(["EXT_mesh_gpu_instancing","KHR_mesh_quantization"])"));
    EXPECT_EQ(glb_bytes(mesh, quantized), json["buffers"][0]["byteLength"]);
}

TEST(GlbWriter, RefusesACoordinateThatIsNotFinite)
{
    mesh::Mesh mesh = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    mesh.surfaces[0].positions_mm[3].y() = std::numeric_limits<float>::infinity();
    mesh::Mesh const good = mesh::make_mesh(mesh::single_axis(1, 1, 1));
    double const none = std::numeric_limits<double>::quiet_NaN();
    for (auto const& placed : { PlacedMesh { .mesh = &mesh },
                                PlacedMesh { .position_mm = { none, 0, 0 }, .mesh = &good },
                                PlacedMesh { .rotation_rad = none, .mesh = &good } }) {
        std::ostringstream out;
        auto const summary = write_glb(out, std::span(&placed, 1));
        ASSERT_FALSE(summary);
        EXPECT_NE(summary.error().message.find("not a finite number"), std::string::npos);
    }
}

} // namespace
} // namespace tractus::exports
