#include "engine/export/glb_lines.h"

#include "engine/base/random.h"

#include <cstring>
#include <fmt/core.h>
#include <gtest/gtest.h>

namespace tractus::exports {
namespace {

void append_u32(std::string& bytes, std::size_t value)
{
    auto const number = static_cast<std::uint32_t>(value);
    bytes.append(reinterpret_cast<char const*>(&number), 4);
}

void append_chunk(std::string& bytes, std::string_view kind, std::string chunk, char filling)
{
    chunk.resize((chunk.size() + 3) / 4 * 4, filling);
    append_u32(bytes, chunk.size());
    bytes.append(kind);
    bytes.append(chunk);
}

// Returns a .glb file with one primitive of four vertices: a trunk of two metres in two pieces, and
// a point beside the middle of the trunk. The primitive's node is at a height of two metres and
// scaled by one half.
std::string glb_of_primitive(std::string const& primitive)
{
    std::string const json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                             R"("nodes":[{"mesh":0,"translation":[0,2,0],"scale":[0.5,0.5,0.5]}],)"
                             R"("meshes":[{"primitives":[)"
        + primitive
        + R"(]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
          R"("min":[0,0,0],"max":[1,2,1]},)"
          R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)"
          R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
          R"("buffers":[{"byteLength":60}]})";
    float const positions[] = { 0, 0, 0, 0, 1, 0, 0, 2, 0, 1, 1, 1 };
    std::uint16_t const indices[] = { 0, 1, 1, 2, 1, 3 };
    std::string data(reinterpret_cast<char const*>(positions), sizeof positions);
    data.append(reinterpret_cast<char const*>(indices), sizeof indices);
    std::string chunks;
    append_chunk(chunks, "JSON", json, ' ');
    append_chunk(chunks, { "BIN\0", 4 }, data, '\0');
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, 12 + chunks.size());
    return bytes + chunks;
}

std::string glb_of_mode(int mode, std::string_view more = "")
{
    return glb_of_primitive(
        fmt::format(R"({{"attributes":{{"POSITION":0}},"mode":{}{}}})", mode, more));
}

constexpr int kLines = 1, kLoop = 2, kStrip = 3, kTriangles = 4;

TEST(GlbLines, StandWhereTheirNodesStand)
{
    auto const lines = read_glb_lines("tree.glb", glb_of_mode(kLines, R"(,"indices":1)"));
    ASSERT_TRUE(lines) << lines.error().message;
    ASSERT_EQ(lines->size(), 3u);
    // The y axis of glTF is the z axis of a plant, and the z axis of glTF is -y. Metres become
    // millimetres.
    EXPECT_TRUE((*lines)[0].from_mm.isApprox(Vec3(0, 0, 2000)));
    EXPECT_TRUE((*lines)[0].to_mm.isApprox(Vec3(0, 0, 2500)));
    EXPECT_TRUE((*lines)[1].to_mm.isApprox(Vec3(0, 0, 3000)));
    EXPECT_TRUE((*lines)[2].from_mm.isApprox(Vec3(0, 0, 2500)));
    EXPECT_TRUE((*lines)[2].to_mm.isApprox(Vec3(500, -500, 2500)));
}

TEST(GlbLines, BecomeAPlant)
{
    auto const lines = read_glb_lines("tree.glb", glb_of_mode(kLines, R"(,"indices":1)")).value();
    auto const plant = plant_from_lines("tree.glb", lines);
    ASSERT_TRUE(plant) << plant.error().message;
    EXPECT_EQ(plant->axes.size(), 2u);
    EXPECT_EQ(plant->segment_count(), 3u);
}

TEST(GlbLines, MayBePairsStripsOrLoops)
{
    EXPECT_EQ(read_glb_lines("a", glb_of_mode(kLines)).value().size(), 2u);
    EXPECT_EQ(read_glb_lines("a", glb_of_mode(kStrip)).value().size(), 3u);
    auto const loop = read_glb_lines("a", glb_of_mode(kLoop)).value();
    ASSERT_EQ(loop.size(), 4u);
    EXPECT_EQ(loop.back().from_mm, loop[2].to_mm);
    EXPECT_EQ(loop.back().to_mm, loop[0].from_mm);
}

TEST(GlbLines, RefuseFilesWithoutLines)
{
    auto const error = [](std::string const& bytes) {
        auto const lines = read_glb_lines("tree.glb", bytes);
        return lines ? "" : lines.error().message;
    };
    EXPECT_EQ(error(glb_of_mode(kTriangles)),
              "tree.glb: there are no lines; export the skeleton's edges as lines, not as "
              "triangles");
    EXPECT_EQ(error("no glTF"), "cannot read the glTF file: it is not a binary glTF file (.glb)");
}

TEST(GlbLines, AnyBytesAreSafe)
{
    auto const whole = glb_of_mode(kLoop, R"(,"indices":1)");
    Random random({ 1, 0, 0 });
    auto const below = [&](std::size_t count) {
        return std::min(static_cast<std::size_t>(random.uniform() * static_cast<double>(count)),
                        count - 1);
    };
    std::size_t refused = 0;
    for (int round = 0; round < 3000; ++round) {
        auto bytes = whole;
        for (int i = 0; i < 1 + round % 4; ++i)
            bytes[below(bytes.size())] = static_cast<char>(below(256));
        if (round % 7 == 0)
            bytes.resize(below(bytes.size()));
        refused += !read_glb_lines("x", bytes);
    }
    EXPECT_GT(refused, 1000u);
}

} // namespace
} // namespace tractus::exports
