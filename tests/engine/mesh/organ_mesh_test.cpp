#include "engine/mesh/organ_mesh.h"

#include "engine/mesh/mesh_measures.h"
#include "engine/mesh/organ_card.h"
#include "tests/engine/mesh/mesh_checks.h"

#include <gtest/gtest.h>

namespace tractus::mesh {
namespace {

struct Box {
    Vec3f low = Vec3f::Constant(1e9f);
    Vec3f high = Vec3f::Constant(-1e9f);
};

Box box_of(TriangleMesh const& mesh)
{
    Box box;
    for (auto const& position : mesh.positions_mm) {
        box.low = box.low.cwiseMin(position);
        box.high = box.high.cwiseMax(position);
    }
    return box;
}

TEST(OrganMesh, KeepsEveryKindWithinItsLengthAndWidth)
{
    using Kind = OrganShape::Kind;
    for (auto const kind : { Kind::Blade, Kind::Needle, Kind::Disc, Kind::Ball }) {
        auto const mesh
            = organ_mesh({ .kind = kind, .length_mm = 60, .width_mm = 20, .petiole_mm = 10 });
        expect_sound(mesh);
        EXPECT_EQ(inside_out_count(mesh), 0u) << static_cast<int>(kind);
        auto const box = box_of(mesh);
        EXPECT_GE(box.low.y(), -1.01f);
        EXPECT_LE(box.high.y(), 60.001f);
        EXPECT_GE(box.low.x(), -10.001f);
        EXPECT_LE(box.high.x(), 10.001f);
        EXPECT_GT(box.high.y(), 50);
        EXPECT_GT(box.high.x(), 8.5f);
    }
}

TEST(OrganMesh, AStraightFlatBladeReachesItsFullSize)
{
    auto const box
        = box_of(organ_mesh({ .length_mm = 50, .width_mm = 30, .fold_rad = 0, .curl_rad = 0 }));
    EXPECT_NEAR(box.high.y(), 50, 1e-3);
    EXPECT_NEAR(box.high.x(), 15, 0.6);
    EXPECT_NEAR(box.high.x(), -box.low.x(), 1e-4);
    EXPECT_NEAR(box.high.z(), 0, 1e-5);
}

TEST(OrganMesh, ABladeFacesUpAndCurlsDown)
{
    auto const mesh = organ_mesh({ .length_mm = 50, .width_mm = 30, .fold_rad = 0, .curl_rad = 1 });
    for (auto const& normal : mesh.normals)
        EXPECT_GT(normal.z(), 0);
    EXPECT_LT(box_of(mesh).low.z(), -10);
}

TEST(OrganMesh, FoldLiftsTheMargins)
{
    auto const mesh
        = organ_mesh({ .length_mm = 50, .width_mm = 30, .fold_rad = 0.5, .curl_rad = 0 });
    EXPECT_NEAR(box_of(mesh).high.z(), 15 * std::sin(0.5), 0.4);
}

TEST(OrganMesh, AnEntireBladeHasTwelveToFortyTriangles)
{
    for (double const petiole_mm : { 0.0, 10.0 }) {
        auto const count = organ_mesh({ .petiole_mm = petiole_mm }).triangle_count();
        EXPECT_GE(count, 12u);
        EXPECT_LE(count, 40u);
    }
}

TEST(OrganMesh, ABladesTextureIsTheUnitSquareAlongTheMidrib)
{
    auto const mesh = organ_mesh({ .length_mm = 50, .width_mm = 30, .curl_rad = 0 });
    for (std::size_t i = 0; i < mesh.positions_mm.size(); ++i) {
        auto const& texture = mesh.texture_coordinates[i];
        EXPECT_GE(texture.minCoeff(), 0);
        EXPECT_LE(texture.maxCoeff(), 1);
        EXPECT_NEAR(texture.y(), mesh.positions_mm[i].y() / 50, 1e-5);
        EXPECT_EQ(texture.x() > 0.5f, mesh.positions_mm[i].x() > 0);
    }
}

TEST(OrganMesh, LobesCutIntoTheMargin)
{
    auto const area = [](OrganShape const& shape) {
        auto const mesh = organ_mesh(shape);
        double sum = 0;
        for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
            sum += area_vector(mesh, i).norm() / 2;
        return sum;
    };
    EXPECT_LT(area({ .lobes = 0.6, .lobe_count = 3 }), 0.85 * area({}));
}

TEST(OrganMesh, SharperEndsAreNarrower)
{
    auto const area = [](double sharpness) {
        auto const mesh = organ_mesh({ .tip_sharpness = sharpness });
        double sum = 0;
        for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
            sum += area_vector(mesh, i).norm();
        return sum;
    };
    EXPECT_GT(area(0), area(1));
    EXPECT_GT(area(1), area(2));
}

TEST(OrganMesh, DiscsAndBallsAreClosed)
{
    for (auto const kind : { OrganShape::Kind::Disc, OrganShape::Kind::Ball }) {
        auto const mesh = organ_mesh({ .kind = kind, .length_mm = 20, .width_mm = 30 });
        EXPECT_EQ(open_edge_count(mesh), 0u);
        EXPECT_GT(volume_mm3(mesh), 0);
    }
}

TEST(OrganMesh, MakesNothingOfAnOrganWithoutSize)
{
    EXPECT_EQ(organ_mesh({ .length_mm = 0 }).triangle_count(), 0u);
    EXPECT_EQ(organ_mesh({ .width_mm = -1 }).triangle_count(), 0u);
}

TEST(OrganMesh, SurvivesExtremeParameters)
{
    expect_sound(organ_mesh({ .petiole_mm = 500,
                              .widest = 0,
                              .tip_sharpness = 100,
                              .base_sharpness = -3,
                              .lobes = 9,
                              .lobe_count = 1000,
                              .fold_rad = 1.5,
                              .curl_rad = 9 }));
}

// The leaf is a rhombus that is cut along its midrib.
TEST(OrganMesh, BendsAndFoldsACutLeaf)
{
    CutLeaf const cut { .corners = { { 0, 0 }, { 0.5, 0.5 }, { 0, 1 }, { -0.5, 0.5 } },
                        .triangles = { { 0, 1, 2 }, { 0, 2, 3 } },
                        .stem_in_picture = { 0.5, 0.75 },
                        .length_in_picture = 0.5 };
    OrganShape shape { .kind = OrganShape::Kind::Leaf,
                       .length_mm = 80,
                       .fold_rad = 0,
                       .curl_rad = 0,
                       .cut = std::make_shared<CutLeaf const>(cut) };
    auto const flat = organ_mesh(shape);
    expect_sound(flat);
    EXPECT_EQ(flat.positions_mm[1], Vec3f(40, 40, 0));
    EXPECT_EQ(flat.texture_coordinates[1], Vec2f(0.75f, 0.5f));
    EXPECT_EQ(inside_out_count(flat), 0u);

    shape.fold_rad = kPi / 6;
    auto const folded = organ_mesh(shape);
    EXPECT_NEAR(folded.positions_mm[1].z(), 20, 1e-4);
    EXPECT_NEAR(folded.positions_mm[3].z(), 20, 1e-4);
    EXPECT_EQ(inside_out_count(folded), 0u);

    shape.curl_rad = kPi / 2; // The leaf curls to a quarter of a circle.
    auto const bent = organ_mesh(shape);
    EXPECT_NEAR(bent.positions_mm[2].y(), 80 / (kPi / 2), 1e-4);
    EXPECT_NEAR(bent.positions_mm[2].z(), -80 / (kPi / 2), 1e-4);
}

// Returns a spray of equal flat leaves along +y, alternately to the right and to the left.
OrganShape spray_of(int count)
{
    OrganShape spray { .kind = OrganShape::Kind::Surface, .length_mm = 100, .width_mm = 100 };
    for (int i = 0; i < count; ++i) {
        double const side = i % 2 == 0 ? 1 : -1;
        LeafOfSpray const leaf { .base_mm = { side, 100.0 * i / count, 0 },
                                 .orientation
                                 = Quat(Eigen::AngleAxisd(-side * kPi / 3, Vec3::UnitZ())),
                                 .length_mm = 20,
                                 .width_mm = 4 };
        BezierPatch patch;
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                patch.control[4 * row + column] = leaf.base_mm
                    + leaf.orientation
                        * Vec3(2 * static_cast<double>(column) - 3,
                               20 * static_cast<double>(row) / 3, 0);
        spray.spray.push_back(leaf);
        spray.patches.push_back(patch);
    }
    return spray;
}

TEST(OrganMesh, ACoarserSprayHasFewerLeavesOfTheSameArea)
{
    auto const area = [](OrganShape const& shape) { return surface_area(organ_mesh(shape, 0)); };
    for (int const count : { 1, 8, 24, 120 }) {
        auto const spray = spray_of(count);
        auto const coarse = coarser_spray(spray);
        EXPECT_NEAR(area(coarse), area(spray), 0.01f * area(spray)) << count;
        EXPECT_EQ(coarse.spray.size(), coarse.patches.size());
        EXPECT_LE(coarse.spray.size(), static_cast<std::size_t>(std::max(8, count / 6)));
        for (auto const& leaf : coarse.spray)
            EXPECT_LE(leaf.length_mm, 30.01);
    }
}

// A card for a whole twig would be one large opaque shape.
TEST(OrganMesh, ASprayHasNoCard)
{
    EXPECT_FALSE(organ_card(organ_mesh(spray_of(24), 0)));
    EXPECT_TRUE(organ_card(organ_mesh(spray_of(1), 0)));
}

} // namespace
} // namespace tractus::mesh
