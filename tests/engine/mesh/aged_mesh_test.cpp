#include "engine/mesh/aged_mesh.h"

#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/random_plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tractus::mesh {
namespace {

std::vector<AgedMesh::Vertices> vertices_at(AgedMesh const& mesh, Plant const& young)
{
    std::vector<AgedMesh::Vertices> vertices;
    mesh.at(young, vertices);
    return vertices;
}

bool is_whole(AgedMesh const& mesh, std::vector<AgedMesh::Vertices> const& vertices)
{
    return std::ranges::equal(
        vertices, mesh.whole().surfaces, [](auto const& at_age, TriangleMesh const& surface) {
            return std::ranges::equal(at_age.positions_mm, surface.positions_mm)
                && std::ranges::equal(at_age.normals, surface.normals);
        });
}

RC_GTEST_PROP(AgedMeshProperties, IsTheWholeMeshOfTheWholePlant, ())
{
    auto const plant = *random_plants();
    AgedMesh const mesh(plant);
    RC_ASSERT(is_whole(mesh, vertices_at(mesh, plant)));
    // The tubes and polygons must be those of make_mesh(). The organs follow them.
    auto const made = make_mesh(plant);
    for (auto const& surface : made.surfaces) {
        auto const& all = mesh.whole().surfaces;
        auto const found = std::find_if(all.begin(), all.end(), [&](TriangleMesh const& other) {
            return other.material == surface.material;
        });
        RC_ASSERT(found != all.end());
        RC_ASSERT(std::equal(surface.positions_mm.begin(), surface.positions_mm.end(),
                             found->positions_mm.begin()));
        RC_ASSERT(
            std::equal(surface.indices.begin(), surface.indices.end(), found->indices.begin()));
    }
    std::size_t triangles = 0;
    for (auto const& surface : mesh.whole().surfaces)
        triangles += surface.triangle_count();
    RC_ASSERT(triangles == made.triangle_count());
    RC_ASSERT(mesh.whole().organs.empty());
}

// The mesh is moved to a random shape of the plant. Its numbers must stay finite and its normals
// valid.
RC_GTEST_PROP(AgedMeshProperties, TakesAnyOtherShapeOfThePlant, ())
{
    auto const seed = *rc::gen::arbitrary<std::uint64_t>();
    auto const plant = random_plant(seed, 60);
    auto other = plant;
    Random random({ .seed = seed });
    for (auto& node : other.node_position_mm)
        node = random.uniform(0, 1) * Vec3(random.normal(), random.normal(), random.normal());
    for (auto& radius : other.node_radius_mm)
        radius *= static_cast<float>(random.uniform(0, 1));
    AgedMesh const mesh(plant);
    auto const on_one = on_threads(1, [&] { return vertices_at(mesh, other); });
    auto const on_five = on_threads(5, [&] { return vertices_at(mesh, other); });
    for (std::size_t i = 0; i < on_one.size(); ++i) {
        RC_ASSERT(std::ranges::equal(on_one[i].positions_mm, on_five[i].positions_mm));
        RC_ASSERT(std::ranges::equal(on_one[i].normals, on_five[i].normals));
        for (auto const& position : on_one[i].positions_mm)
            RC_ASSERT(position.allFinite());
        auto const& whole = mesh.whole().surfaces[i].normals;
        for (std::size_t v = 0; v < whole.size(); ++v)
            RC_ASSERT(std::abs(on_one[i].normals[v].norm() - whole[v].norm()) < 1e-3f);
    }
}

TEST(AgedMesh, ItsWholeIsSound)
{
    auto const plant = sample_tree(3);
    AgedMesh const mesh(plant);
    ASSERT_EQ(mesh.whole().surfaces.size(), 2u);
    for (auto const& surface : mesh.whole().surfaces) {
        expect_sound(surface);
        EXPECT_EQ(inside_out_count(surface), 0u);
    }
}

// The rotation is about a horizontal axis, perpendicular to the plant's axis, so rings do not
// rotate about it.
TEST(AgedMesh, LeansWithAnAxisThatLeans)
{
    auto plant = single_axis(6, 10, 3);
    plant.organ_shapes = { OrganShape {} };
    plant.organs = { { .segment = 5, .position_mm = plant.node_position_mm.back() } };
    Eigen::Affine3d const turn
        = Eigen::Translation3d(10, 20, 30) * Eigen::AngleAxisd(0.7, Vec3(1, 2, 0).normalized());
    auto turned = plant;
    for (auto& node : turned.node_position_mm)
        node = turn * node;
    for (auto& organ : turned.organs) {
        organ.position_mm = turn * organ.position_mm;
        organ.orientation = Quat(turn.rotation()) * organ.orientation;
    }
    AgedMesh const mesh(plant);
    auto const vertices = vertices_at(mesh, turned);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        auto const& whole = mesh.whole().surfaces[i];
        for (std::size_t v = 0; v < whole.positions_mm.size(); ++v) {
            Vec3 const position = turn * whole.positions_mm[v].cast<double>();
            Vec3 const normal = turn.rotation() * whole.normals[v].cast<double>();
            ASSERT_LT((vertices[i].positions_mm[v].cast<double>() - position).norm(), 0.01);
            ASSERT_LT((vertices[i].normals[v].cast<double>() - normal).norm(), 1e-4);
        }
    }
}

TEST(AgedMesh, WhatHasNotGrownIsAPoint)
{
    auto const plant = sample_tree(2);
    auto seed = plant;
    for (auto& node : seed.node_position_mm)
        node = { 1, 2, 3 };
    for (auto& radius : seed.node_radius_mm)
        radius = 0;
    for (auto& organ : seed.organs) {
        organ.position_mm = { 1, 2, 3 };
        organ.scale = Vec3f::Zero();
    }
    AgedMesh const mesh(plant);
    for (auto const& surface : vertices_at(mesh, seed))
        for (auto const& position : surface.positions_mm)
            ASSERT_LT((position - Vec3f(1, 2, 3)).norm(), 1e-3f);
}

// A pole of four segments of 50 mm. Two and a half of these have grown, with half their final
// thickness.
TEST(AgedMesh, GoesAsFarAndIsAsWideAsTheAxisIs)
{
    auto const pole = single_axis(4, 8, 8);
    auto young = pole;
    for (std::size_t node = 0; node < 5; ++node)
        young.node_radius_mm[node] = node < 3 ? 4 : 0;
    young.node_position_mm[3] = young.node_position_mm[4] = { 0, 0, 125 };
    AgedMesh const mesh(pole);
    auto const now = vertices_at(mesh, young)[0].positions_mm;
    auto const& whole = mesh.whole().surfaces[0].positions_mm;
    for (std::size_t v = 0; v < now.size(); ++v) {
        float const height = whole[v].z();
        float const expected = height <= 100 ? height
            : height <= 150                  ? 100 + (height - 100) / 2
                                             : 125;
        EXPECT_NEAR(now[v].z(), expected, 1e-3f);
        float const width = height <= 100 ? 0.5f : height <= 150 ? 0.5f * (150 - height) / 50 : 0;
        EXPECT_NEAR(now[v].head<2>().norm(), width * whole[v].head<2>().norm(), 1e-3f);
    }
}

} // namespace
} // namespace tractus::mesh
