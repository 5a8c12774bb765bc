#include "engine/mesh/coarse_mesh.h"

#include "engine/mesh/make_mesh.h"
#include "engine/mesh/mesh_measures.h"
#include "tests/engine/mesh/bent_leaf.h"
#include "tests/engine/mesh/edge_count.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::mesh {

namespace {

// Distance of a place from triangles, by 21 x 21 points on each.
float distance_mm(Vec3f const& place, TriangleMesh const& mesh,
                  std::vector<std::uint32_t> const& indices)
{
    constexpr int kSteps = 20;
    float least_mm = 1e9f;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (int a = 0; a <= kSteps; ++a)
            for (int b = 0; a + b <= kSteps; ++b) {
                float const u = static_cast<float>(a) / kSteps;
                float const v = static_cast<float>(b) / kSteps;
                Vec3f const at = mesh.positions_mm[indices[i]] * (1 - u - v)
                    + mesh.positions_mm[indices[i + 1]] * u + mesh.positions_mm[indices[i + 2]] * v;
                least_mm = std::min(least_mm, (at - place).norm());
            }
    return least_mm;
}

} // namespace

TEST(CoarseVersions, HaveFewerTrianglesTheCoarserTheyAreAndKeepTheShape)
{
    auto const leaf = bent_leaf();
    auto const versions = coarse_versions(leaf);
    ASSERT_GE(versions.size(), 2u);
    EXPECT_LE(versions.back().indices.size(), 3 * 12u);
    auto former = leaf.indices.size();
    float error_mm = 0;
    for (auto const& version : versions) {
        EXPECT_LT(version.indices.size(), former);
        EXPECT_GE(version.error_mm, error_mm);
        EXPECT_LT(version.error_mm, 3.1f);
        former = version.indices.size();
        error_mm = version.error_mm;
        // The points on the triangles are half a millimetre from each other.
        for (auto const& position : leaf.positions_mm)
            EXPECT_LT(distance_mm(position, leaf, version.indices), 3 * error_mm + 0.5f);
    }
}

TEST(CoarseVersions, OfTwoTrianglesAreNone)
{
    TriangleMesh card;
    card.positions_mm = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
    card.indices = { 0, 1, 2, 0, 2, 3 };
    EXPECT_TRUE(coarse_versions(card).empty());
}

TEST(SimplifiedMesh, HasTheVerticesOfItsTrianglesOnly)
{
    auto const leaf = bent_leaf();
    auto const made = simplified(leaf, 0.3f);
    EXPECT_LT(made.indices.size(), leaf.indices.size() / 2);
    EXPECT_LT(made.positions_mm.size(), leaf.positions_mm.size());
    ASSERT_EQ(made.normals.size(), made.positions_mm.size());
    ASSERT_EQ(made.texture_coordinates.size(), made.positions_mm.size());
    std::vector<bool> is_used(made.positions_mm.size());
    for (auto const index : made.indices) {
        ASSERT_LT(index, is_used.size());
        is_used[index] = true;
    }
    EXPECT_EQ(std::ranges::count(is_used, false), 0);
    // Each vertex is one of the leaf's, with its normal and its place in the picture.
    for (std::size_t i = 0; i < made.positions_mm.size(); ++i) {
        auto const found = std::ranges::find(leaf.positions_mm, made.positions_mm[i]);
        ASSERT_NE(found, leaf.positions_mm.end());
        auto const at = static_cast<std::size_t>(found - leaf.positions_mm.begin());
        EXPECT_EQ(leaf.normals[at], made.normals[i]);
        EXPECT_EQ(leaf.texture_coordinates[at], made.texture_coordinates[i]);
    }
}

TEST(OrganSpindle, IsClosedAndLooksOutwards)
{
    Plant plant;
    plant.materials = { Material { .kind = Material::Kind::Bark } };
    plant.organ_shapes = { { .kind = OrganShape::Kind::Ball, .length_mm = 6, .width_mm = 3 } };
    plant.organs = { Organ {} };
    auto const bud = make_prototype(plant, 0);
    auto const spindle = make_prototype(plant, 0, { .organs = MeshOptions::Organs::Cards });
    ASSERT_GT(bud.triangle_count(), 6u);
    ASSERT_EQ(spindle.triangle_count(), 6u);
    ASSERT_EQ(spindle.texture_coordinates.size(), spindle.positions_mm.size());
    std::vector<Corners> triangles;
    double six_volumes_mm3 = 0;
    for (std::size_t i = 0; i < spindle.indices.size(); i += 3) {
        auto const at = [&](std::size_t k) { return spindle.positions_mm[spindle.indices[i + k]]; };
        auto& corners = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = { at(k).x(), at(k).y(), at(k).z() };
        six_volumes_mm3 += static_cast<double>(at(0).dot(at(1).cross(at(2))));
    }
    EXPECT_EQ(count_bad_edges(triangles), 0u);
    EXPECT_GT(six_volumes_mm3, 0);
    EXPECT_NEAR(bounds(spindle).min_mm.y(), bounds(bud).min_mm.y(), 1e-4);
    EXPECT_NEAR(bounds(spindle).max_mm.y(), bounds(bud).max_mm.y(), 1e-4);
}

} // namespace tractus::mesh
