#include "engine/mesh/solid_parts.h"

#include "engine/mesh/mesh_measures.h"
#include "tests/engine/mesh/edge_count.h"
#include "tests/engine/mesh/sample_plants.h"

#include <gtest/gtest.h>

namespace tractus::mesh {
namespace {

ClosedMesh closed(Plant const& plant, SolidOptions const& options = {})
{
    return closed_surfaces(solid_parts(plant, options));
}

// A plant that is nothing but one organ.
Plant lone_organ(OrganShape const& shape)
{
    Plant plant;
    plant.materials = { Material { .kind = Material::Kind::Leaf } };
    plant.organ_shapes = { shape };
    plant.organs = { Organ {} };
    return plant;
}

TEST(SolidParts, EveryBranchAndLeafIsClosed)
{
    auto const plant = sample_tree(1);
    auto const mesh = closed(plant);
    EXPECT_EQ(count_bad_edges(corners_of(mesh)), 0u);
    EXPECT_GE(count_surfaces(mesh), plant.axes.size() + plant.organs.size());
    EXPECT_GT(volume_mm3(mesh), 0);
}

TEST(SolidParts, LeavesAreLeftOutIfAskedFor)
{
    auto const plant = sample_tree(1);
    auto const mesh = closed(plant, { .organs = SolidOptions::Organs::LeftOut });
    EXPECT_EQ(count_surfaces(mesh), plant.axes.size());
    for (auto const material : mesh.materials)
        EXPECT_EQ(material, 0);
}

TEST(SolidParts, AThinBranchIsAsThickAsAsked)
{
    auto const box = box_mm(closed(single_axis(3, 0.1, 0.05), { .least_thickness_mm = 2 }));
    EXPECT_GE(box.sizes().x(), 2);
    EXPECT_GE(box.sizes().y(), 2);
    EXPECT_LE(box.sizes().head<2>().maxCoeff(), 2.4);
    auto const thick = box_mm(closed(single_axis(3, 10, 10), { .least_thickness_mm = 2 }));
    EXPECT_NEAR(thick.sizes().x(), 20, 0.5) << "thick branches stay as they are";
}

TEST(SolidParts, AScaledPlantIsStillAsThickAsAsked)
{
    auto const plant = sample_tree(1);
    auto const whole = box_mm(closed(plant, { .least_thickness_mm = 40 }));
    auto const small = box_mm(closed(plant, { .scale = 0.05, .least_thickness_mm = 2 }));
    EXPECT_LT((0.05f * whole.min() - small.min()).norm(), 0.1f);
    EXPECT_LT((0.05f * whole.max() - small.max()).norm(), 0.1f);
}

TEST(SolidParts, ALeafBecomesAPlateOfItsThickness)
{
    auto const plant = lone_organ({ .length_mm = 60, .width_mm = 30 });
    double const area = double { surface_area(make_prototype(plant, 0)) };
    auto const mesh = closed(plant, { .least_thickness_mm = 1 });
    EXPECT_EQ(count_bad_edges(corners_of(mesh)), 0u);
    EXPECT_GE(volume_mm3(mesh), area);
    EXPECT_LE(volume_mm3(mesh), 1.15 * area);
}

TEST(SolidParts, EveryKindOfOrganIsClosed)
{
    using Kind = OrganShape::Kind;
    for (auto const kind : { Kind::Blade, Kind::Needle, Kind::Disc, Kind::Ball }) {
        auto plant = lone_organ({ .kind = kind,
                                  .length_mm = 20,
                                  .width_mm = 2,
                                  .petiole_mm = 4,
                                  .lobes = 0.3,
                                  .lobe_count = 3 });
        auto const mesh = closed(plant, { .least_thickness_mm = 0.5 });
        EXPECT_EQ(count_bad_edges(corners_of(mesh)), 0u) << static_cast<int>(kind);
        EXPECT_GT(volume_mm3(mesh), 0) << static_cast<int>(kind);
        double const volume = volume_mm3(mesh);
        plant.organs[0].scale = { -1, 1, 1 };
        EXPECT_NEAR(volume_mm3(closed(plant, { .least_thickness_mm = 0.5 })), volume, 1e-3 * volume)
            << "a mirrored organ is not turned inside out";
    }
}

TEST(SolidParts, ABallStaysABall)
{
    auto plant = lone_organ({ .kind = OrganShape::Kind::Ball, .length_mm = 20, .width_mm = 20 });
    auto const mesh = closed(plant);
    EXPECT_EQ(count_surfaces(mesh), 1u);
    // A polyhedron whose corners lie on the ball is smaller.
    double const ball_mm3 = 4.0 / 3 * kPi * 1000;
    EXPECT_GT(volume_mm3(mesh), 0.85 * ball_mm3);
    EXPECT_LT(volume_mm3(mesh), ball_mm3);
}

TEST(SolidParts, CopiesAtOnePlaceAreToldApart)
{
    auto plant = lone_organ({ .length_mm = 60, .width_mm = 30 });
    plant.organs.resize(3);
    auto const mesh = closed(plant);
    EXPECT_EQ(count_bad_edges(corners_of(mesh)), 0u);
    EXPECT_EQ(count_surfaces(mesh), 3u);
}

// Three triangles that share an edge, and one that is there twice.
TEST(SheetPieces, ASurfaceIsCutWhereItBranches)
{
    TriangleMesh mesh;
    mesh.positions_mm = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
    mesh.indices = { 0, 1, 2, 0, 1, 3, 0, 1, 4, 1, 0, 4 };
    auto const pieces = split_sheet(mesh);
    ASSERT_EQ(pieces.size(), 3u);
    for (auto const& piece : pieces)
        EXPECT_EQ(piece.rim.size(), 3u);
}

TEST(ClosedMesh, AHollowIsFilled)
{
    auto const ball = [](double size, bool is_hollow) {
        auto const kind = OrganShape::Kind::Ball;
        auto mesh = closed(lone_organ({ .kind = kind, .length_mm = size, .width_mm = size }));
        for (auto& triangle : mesh.triangles)
            if (is_hollow)
                std::swap(triangle[1], triangle[2]);
        return mesh;
    };
    auto mesh = ball(20, false);
    double const volume = volume_mm3(mesh);
    append(mesh, ball(10, true));
    EXPECT_LT(volume_mm3(mesh), volume);
    fill_hollows(mesh);
    EXPECT_EQ(count_surfaces(mesh), 1u);
    EXPECT_NEAR(volume_mm3(mesh), volume, 1e-6 * volume);
}

} // namespace
} // namespace tractus::mesh
