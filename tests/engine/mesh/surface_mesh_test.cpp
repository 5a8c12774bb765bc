#include "engine/mesh/surface_mesh.h"

#include "engine/mesh/organ_mesh.h"
#include "tests/engine/mesh/mesh_checks.h"

#include <gtest/gtest.h>

namespace tractus::mesh {
namespace {

// Returns a patch over a rectangle in the organ's plane, whose least x is `left`. Its middle bulges
// by `bulge`.
BezierPatch patch(double left, double width, double length, double bulge)
{
    BezierPatch result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            bool const inner = row > 0 && row < 3;
            result.control[4 * row + column]
                = { left + width * static_cast<double>(column) / 3,
                    length * (1 - static_cast<double>(row) / 3), inner ? bulge : 0 };
        }
    return result;
}

OrganShape surface(std::vector<BezierPatch> patches)
{
    OrganShape shape;
    shape.kind = OrganShape::Kind::Surface;
    shape.patches = std::move(patches);
    return shape;
}

TEST(SurfaceMesh, LiesOnThePatch)
{
    auto const arch = patch(0, 10, 30, 12);
    auto const mesh = surface_mesh(surface({ arch }), 4);
    expect_sound(mesh);
    EXPECT_EQ(inside_out_count(mesh), 0u);
    for (std::size_t i = 0; i < mesh.positions_mm.size(); ++i) {
        double const s = 1 - mesh.positions_mm[i].y() / 30.0;
        double const t = mesh.positions_mm[i].x() / 10.0;
        EXPECT_LT((mesh.positions_mm[i].cast<double>() - arch.at(s, t)).norm(), 1e-4);
        Vec3 const normal = arch.normal_at(s, t).normalized();
        EXPECT_LT((mesh.normals[i].cast<double>() - normal).norm(), 1e-4);
        EXPECT_NEAR(mesh.texture_coordinates[i].x(), t, 1e-5);
        EXPECT_NEAR(mesh.texture_coordinates[i].y(), 1 - s, 1e-5);
    }
}

TEST(SurfaceMesh, IsFinerWhereItBendsAndWhenAsked)
{
    auto const count = [](double bulge, int subdivision) {
        return surface_mesh(surface({ patch(0, 10, 30, bulge) }), subdivision).triangle_count();
    };
    EXPECT_EQ(count(0, 4), 2u); // A flat patch needs only one quadrangle.
    EXPECT_GT(count(12, 4), count(3, 4));
    EXPECT_GT(count(12, 8), count(12, 4));
    EXPECT_GT(count(12, 4), count(12, 2));
    EXPECT_EQ(count(12, 0), count(12, 1));
}

TEST(SurfaceMesh, SharesTheSeamsOfNeighbors)
{
    auto left = patch(-10, 10, 30, 12);
    auto right = patch(0, 10, 30, 12);
    // The seam of the patches stays the same, but the normals along it differ.
    right.control[5].z() = 20;
    auto const apart = surface_mesh(surface({ left, right }), 4);
    left.neighbors[BezierPatch::Right] = 1;
    right.neighbors[BezierPatch::Left] = 0;
    auto const joined = surface_mesh(surface({ left, right }), 4);
    expect_sound(joined);
    EXPECT_EQ(joined.triangle_count(), apart.triangle_count());
    auto const strips = static_cast<std::size_t>(
        std::lround(std::sqrt(static_cast<double>(apart.triangle_count()) / 4)));
    EXPECT_EQ(apart.positions_mm.size() - joined.positions_mm.size(), strips + 1);
}

// Returns a row of two patches, the right one three times as wide as the left one. Above each of
// them is another patch of half its length.
std::vector<BezierPatch> four_patches()
{
    std::vector<BezierPatch> patches { patch(-5, 10, 20, 3), patch(5, 30, 20, 3),
                                       patch(-5, 10, 10, 3), patch(5, 30, 10, 3) };
    for (std::size_t i = 2; i < 4; ++i)
        for (auto& point : patches[i].control)
            point.y() += 20;
    // The neighbours are in the order of Side; rows of control points begin at the tip.
    using enum BezierPatch::Side;
    patches[0].neighbors = { 2, BezierPatch::kNoPatch, BezierPatch::kNoPatch, 1 };
    patches[1].neighbors = { 3, BezierPatch::kNoPatch, 0, BezierPatch::kNoPatch };
    patches[2].neighbors = { BezierPatch::kNoPatch, 0, BezierPatch::kNoPatch, 3 };
    patches[3].neighbors = { BezierPatch::kNoPatch, 1, 2, BezierPatch::kNoPatch };
    return patches;
}

// Returns texture coordinates of a point. Each patch has an equal share of the texture, whatever
// its size.
Vec2 on_four_patches(Vec3f const& at)
{
    return { at.x() < 5 ? (at.x() + 5) / 20 : 0.5 + (at.x() - 5) / 60,
             at.y() < 20 ? at.y() / 40 : 0.5 + (at.y() - 20) / 20 };
}

TEST(SurfaceMesh, LaysATextureOnPatches)
{
    auto const mesh = surface_mesh(surface(four_patches()), 4, TextureMapping::OnPatches);
    expect_sound(mesh);
    for (std::size_t i = 0; i < mesh.positions_mm.size(); ++i)
        EXPECT_LT(
            (mesh.texture_coordinates[i].cast<double>() - on_four_patches(mesh.positions_mm[i]))
                .norm(),
            1e-5);
}

// The texture must not depend on the orientation of the patches, whose rows and columns may be
// exchanged or reversed.
TEST(SurfaceMesh, LaysATextureAsTheOrganLies)
{
    auto patches = four_patches();
    for (auto& patch : patches) {
        auto const before = patch;
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                patch.control[4 * row + column] = before.control[4 * (3 - column) + (3 - row)];
        auto const& sides = before.neighbors;
        patch.neighbors = { sides[BezierPatch::Right], sides[BezierPatch::Left],
                            sides[BezierPatch::Below], sides[BezierPatch::Above] };
    }
    auto const mesh = surface_mesh(surface(patches), 4, TextureMapping::OnPatches);
    for (std::size_t i = 0; i < mesh.positions_mm.size(); ++i)
        EXPECT_LT(
            (mesh.texture_coordinates[i].cast<double>() - on_four_patches(mesh.positions_mm[i]))
                .norm(),
            1e-5);
}

TEST(SurfaceMesh, LaysATextureOnTheBoxOfPatchesThatAreNoGrid)
{
    auto patches = four_patches();
    patches.pop_back();
    patches[1].neighbors[BezierPatch::Above] = BezierPatch::kNoPatch;
    patches[2].neighbors[BezierPatch::Right] = BezierPatch::kNoPatch;
    auto const on_box = surface_mesh(surface(patches), 4);
    auto const on_patches = surface_mesh(surface(patches), 4, TextureMapping::OnPatches);
    ASSERT_EQ(on_box.positions_mm.size(), on_patches.positions_mm.size());
    for (std::size_t i = 0; i < on_box.positions_mm.size(); ++i)
        EXPECT_EQ(on_box.texture_coordinates[i], on_patches.texture_coordinates[i]);
}

TEST(SurfaceMesh, FillsPatchesThatNarrowToAPoint)
{
    auto petal = patch(-5, 10, 30, 6);
    for (std::size_t column = 0; column < 4; ++column)
        petal.control[12 + column] = Vec3::Zero();
    auto const mesh = surface_mesh(surface({ petal }), 4);
    expect_sound(mesh);
    EXPECT_EQ(inside_out_count(mesh), 0u);
    EXPECT_GT(mesh.triangle_count(), 8u);
}

TEST(SurfaceMesh, HasABackForOpaqueMaterials)
{
    auto shape = surface({ patch(0, 10, 30, 12) });
    auto const front = surface_mesh(shape, 4);
    shape.has_back = true;
    auto const both = surface_mesh(shape, 4);
    expect_sound(both);
    EXPECT_EQ(both.triangle_count(), 2 * front.triangle_count());
    EXPECT_EQ(inside_out_count(both), 0u);
    EXPECT_EQ(open_edge_count(both), 0u);
}

TEST(SurfaceMesh, IsNothingWithoutPatches)
{
    EXPECT_EQ(organ_mesh(surface({})).triangle_count(), 0u);
    EXPECT_EQ(organ_mesh(surface({ patch(0, 0, 0, 0) })).triangle_count(), 0u);
}

} // namespace
} // namespace tractus::mesh
