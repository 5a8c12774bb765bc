#include "app/render/sky_visibility.h"
#include "engine/mesh/mesh_measures.h"
#include "tests/app/render/small_mesh.h"

#include <gtest/gtest.h>

namespace tractus::render {

namespace {

// Returns a square roof of leaves, 1 m wide and 500 mm above the ground.
mesh::Mesh roof()
{
    mesh::Mesh mesh;
    mesh.materials.push_back({ .name = "leaf", .kind = Material::Kind::Leaf });
    auto& leaf = mesh.organs.emplace_back();
    add_quad(leaf.prototype,
             { Vec3f(-50, -50, 0), Vec3f(50, -50, 0), Vec3f(50, 50, 0), Vec3f(-50, 50, 0) });
    for (int layer = 0; layer < 5; ++layer)
        for (int x = 0; x < 10; ++x)
            for (int y = 0; y < 10; ++y)
                leaf.instances.push_back(
                    { .translation_mm
                      = Vec3f(static_cast<float>(x) * 100 - 450, static_cast<float>(y) * 100 - 450,
                              500 + static_cast<float>(layer) * 20) });
    return mesh;
}

} // namespace

TEST(SkyVisibility, IsLowUnderLeavesAndFullAboveThem)
{
    SkyVisibility const sky(roof());
    EXPECT_LT(sky.at(Vec3f(0, 0, 300)), 0.4f);
    EXPECT_GT(sky.at(Vec3f(0, 0, 580)), sky.at(Vec3f(0, 0, 300)) + 0.2f);
}

TEST(SkyVisibility, GrowsTowardsTheRim)
{
    SkyVisibility const sky(roof());
    EXPECT_GT(sky.at(Vec3f(600, 0, 250)), sky.at(Vec3f(0, 0, 250)) + 0.1f);
}

TEST(SkyVisibility, ShadesTheGroundBelowMost)
{
    auto const ground = SkyVisibility(roof()).ground();
    auto const at = [&](int x, int y) {
        return ground.values[static_cast<std::size_t>(y * ground.side + x)];
    };
    EXPECT_LT(at(ground.side / 2, ground.side / 2), 0.6f);
    EXPECT_GT(at(0, 0), at(ground.side / 2, ground.side / 2) + 0.15f);
    EXPECT_LT(ground.corner_mm.x(), -500);
    EXPECT_GT(ground.corner_mm.x() + ground.size_mm.x(), 500);
}

TEST(SkyVisibility, IsFullForAnEmptyMesh)
{
    EXPECT_EQ(SkyVisibility(mesh::Mesh()).at(Vec3f::Zero()), 1.0f);
}

TEST(MeshBounds, HoldSurfacesAndEveryInstance)
{
    auto const box = mesh::bounds(post_with_leaves());
    EXPECT_TRUE(box.min_mm.isApprox(Vec3(-250, -20, 0), 1e-4));
    EXPECT_TRUE(box.max_mm.isApprox(Vec3(250, 20, 300), 1e-4));
}

} // namespace tractus::render
