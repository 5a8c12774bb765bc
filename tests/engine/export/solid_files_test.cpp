#include "engine/export/ply_writer.h"
#include "engine/export/stl_writer.h"

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/solid_parts.h"
#include "tests/engine/export/stl_triangles.h"
#include "tests/engine/mesh/sample_plants.h"

#include <cstring>
#include <gtest/gtest.h>
#include <sstream>
#include <string>

namespace tractus::exports {
namespace {

mesh::ClosedMesh solid_tree()
{
    return mesh::closed_surfaces(mesh::solid_parts(mesh::sample_tree(1), {}));
}

TEST(StlWriter, HasEveryTriangleAndIsClosed)
{
    auto const mesh = solid_tree();
    std::ostringstream out;
    ASSERT_TRUE(write_stl(out, mesh));
    auto const bytes = out.str();
    EXPECT_FALSE(bytes.starts_with("solid")) << "that would be STL in text form";
    auto const triangles = mesh::stl_triangles(bytes);
    EXPECT_EQ(triangles.size(), mesh.triangles.size());
    EXPECT_EQ(bytes.size(), 84 + 50 * triangles.size());
    EXPECT_EQ(mesh::count_bad_edges(triangles), 0u);
}

// The right-hand rule: the corners are counter-clockwise around the normal.
TEST(StlWriter, NormalsBelongToTheirCorners)
{
    mesh::ClosedMesh mesh;
    mesh.positions_mm = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 } };
    mesh.triangles = { { 0, 1, 2 } };
    std::ostringstream out;
    ASSERT_TRUE(write_stl(out, mesh));
    float normal[3] {};
    std::memcpy(normal, out.str().data() + 84, sizeof normal);
    EXPECT_EQ(normal[2], 1);
}

struct PlyCounts {
    std::size_t vertices = 0;
    std::size_t faces = 0;
    std::size_t header_bytes = 0;
};

PlyCounts ply_header(std::string const& bytes)
{
    PlyCounts counts;
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
        counts.header_bytes += line.size() + 1;
        if (line.starts_with("element vertex "))
            counts.vertices = std::stoul(line.substr(15));
        if (line.starts_with("element face "))
            counts.faces = std::stoul(line.substr(13));
        if (line == "end_header")
            break;
    }
    return counts;
}

TEST(PlyWriter, HasEveryTriangleOfEveryLeaf)
{
    auto const mesh = mesh::make_mesh(mesh::sample_tree(1));
    std::ostringstream out;
    ASSERT_TRUE(write_ply(out, mesh));
    auto const counts = ply_header(out.str());
    EXPECT_EQ(counts.faces, mesh.triangle_count());
    EXPECT_EQ(out.str().size(), counts.header_bytes + 27 * counts.vertices + 13 * counts.faces);
}

TEST(PlyWriter, VerticesHaveTheColourOfTheirMaterial)
{
    auto const plant = mesh::sample_tree(1);
    auto const mesh = solid_tree();
    std::ostringstream out;
    ASSERT_TRUE(write_ply(out, mesh, plant.materials));
    auto const bytes = out.str();
    auto const counts = ply_header(bytes);
    ASSERT_EQ(counts.vertices, mesh.positions_mm.size());
    for (std::size_t i : { std::size_t { 0 }, counts.vertices - 1 }) {
        auto const* const vertex = bytes.data() + counts.header_bytes + 27 * i;
        Vec3f position;
        std::memcpy(position.data(), vertex, sizeof(float) * 3);
        EXPECT_EQ(position, mesh.positions_mm[i]);
        auto const& color = plant.materials[mesh.materials[i]].base_color;
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(static_cast<unsigned char>(vertex[24 + k]), 255 * color[k], 0.51);
    }
}

TEST(SolidFiles, SayThatTheStreamFailed)
{
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_NE(write_stl(out, {}).error().message.find("disk is full"), std::string::npos);
    EXPECT_NE(write_ply(out, mesh::ClosedMesh(), {}).error().message.find("disk is full"),
              std::string::npos);
}

} // namespace
} // namespace tractus::exports
