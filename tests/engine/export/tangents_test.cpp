#include "engine/export/tangents.h"

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh.h"
#include "tests/engine/mesh/sample_plants.h"

#include <gtest/gtest.h>

namespace tractus::exports {
namespace {

// Returns a square of side 1 that faces up. Its texture lies on it like a picture with the first
// row at the top, so v decreases as y increases.
mesh::TriangleMesh square()
{
    mesh::TriangleMesh mesh;
    for (auto const& corner : { Vec2f(0, 0), Vec2f(1, 0), Vec2f(1, 1), Vec2f(0, 1) }) {
        mesh.positions_mm.push_back({ corner.x(), corner.y(), 0.0f });
        mesh.normals.push_back(Vec3f::UnitZ());
        mesh.texture_coordinates.push_back({ corner.x(), 1.0f - corner.y() });
    }
    for (std::uint32_t const index : { 0U, 1U, 2U, 0U, 2U, 3U })
        mesh.indices.push_back(index);
    return mesh;
}

BulkVector<Eigen::Vector4f> tangents_of(mesh::TriangleMesh const& mesh)
{
    BulkVector<Eigen::Vector4f> tangents;
    find_tangents(view_of(mesh), tangents);
    return tangents;
}

TEST(Tangents, OfASquareAreItsPicturesSides)
{
    auto mesh = square();
    for (auto const& tangent : tangents_of(mesh))
        EXPECT_TRUE(tangent.isApprox(Eigen::Vector4f(1, 0, 0, 1))) << tangent.transpose();
    for (auto& texture : mesh.texture_coordinates) // Mirrors the texture coordinates.
        texture.x() = 1 - texture.x();
    for (auto const& tangent : tangents_of(mesh))
        EXPECT_TRUE(tangent.isApprox(Eigen::Vector4f(-1, 0, 0, -1))) << tangent.transpose();
}

TEST(Tangents, AreAcrossTheNormalWhereTheTextureTellsNothing)
{
    auto mesh = square();
    for (auto& texture : mesh.texture_coordinates)
        texture.setZero();
    for (auto const& tangent : tangents_of(mesh)) {
        EXPECT_NEAR(tangent.head<3>().norm(), 1, 1e-6);
        EXPECT_NEAR(tangent.z(), 0, 1e-6);
        EXPECT_EQ(std::abs(tangent.w()), 1);
    }
}

// Around a tube, u increases counterclockwise as seen from the tube's tip, and v increases towards
// the tip.
TEST(Tangents, RunRoundATube)
{
    auto const mesh = mesh::make_mesh(mesh::single_axis(6, 40, 8));
    auto const& tube = mesh.surfaces.at(0);
    auto const tangents = tangents_of(tube);
    ASSERT_EQ(tangents.size(), tube.positions_mm.size());
    int steps = 0;
    for (std::size_t i = 0; i < tangents.size(); ++i) {
        Vec3f const tangent = tangents[i].head<3>();
        EXPECT_NEAR(tangent.norm(), 1, 1e-5);
        EXPECT_NEAR(tangent.dot(tube.normals[i]), 0, 1e-5);
        if (i == 0)
            continue;
        // Considers only neighbouring corners of the same ring, which have equal v.
        Vec2f const step = tube.texture_coordinates[i] - tube.texture_coordinates[i - 1];
        Vec3f const way_mm = tube.positions_mm[i] - tube.positions_mm[i - 1];
        if (step.y() != 0 || step.x() <= 0 || way_mm.norm() < 1e-3f)
            continue;
        EXPECT_GT(tangent.dot(way_mm.normalized()), 0.5f) << i;
        EXPECT_EQ(tangents[i].w(), -1) << i;
        ++steps;
    }
    EXPECT_GT(steps, 30);
}

} // namespace
} // namespace tractus::exports
