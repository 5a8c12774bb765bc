#include "engine/mesh/closed_shell.h"

#include "engine/base/random.h"
#include "engine/mesh/cube_table.h"
#include "tests/engine/mesh/edge_count.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/random_plants.h"
#include "tests/engine/mesh/sample_plants.h"

#include <cmath>
#include <rapidcheck/gtest.h>
#include <vector>

namespace tractus::mesh {
namespace {

ClosedMesh shell(Plant const& plant, SolidOptions const& options)
{
    auto const mesh = closed_shell(solid_parts(plant, options));
    EXPECT_TRUE(mesh) << mesh.error().message;
    return mesh ? *mesh : ClosedMesh();
}

// A stem that forks into two branches, with a leaf at the end of one.
Plant fork()
{
    auto plant = single_axis(2, 6, 5);
    plant.materials.push_back({ .name = "leaf", .kind = Material::Kind::Leaf });
    plant.organ_shapes = { OrganShape { .material = 1, .length_mm = 40, .width_mm = 20 } };
    Random random({});
    for (double const side : { -1.0, 1.0 })
        append_axis(plant,
                    { .base_mm = { 0, 0, 100 },
                      .direction = { side, 0, 1 },
                      .segment_mm = 40,
                      .segment_count = 2,
                      .radius_mm = 3,
                      .tip_radius_mm = 2,
                      .parent_segment = 1,
                      .parent_axis = 0,
                      .order = 1 },
                    random);
    plant.organs = { { .segment = 3, .position_mm = plant.node_position_mm[5] } };
    return plant;
}

// Every combination of corners inside and outside is met in a random grid.
TEST(CubeTable, TrianglesOfNeighboursFitTogether)
{
    constexpr int kSide = 16;
    Random random({ .seed = 1 });
    std::vector<bool> inside(kSide * kSide * kSide);
    auto const at = [&](int x, int y, int z) {
        return static_cast<std::size_t>((z * kSide + y) * kSide + x);
    };
    for (int z = 1; z + 1 < kSide; ++z)
        for (int y = 1; y + 1 < kSide; ++y)
            for (int x = 1; x + 1 < kSide; ++x)
                inside[at(x, y, z)] = random.uniform(0, 1) < 0.5;
    std::vector<Corners> triangles;
    for (int z = 0; z + 1 < kSide; ++z)
        for (int y = 0; y + 1 < kSide; ++y)
            for (int x = 0; x + 1 < kSide; ++x) {
                unsigned corners = 0;
                for (int i = 0; i < 8; ++i)
                    if (inside[at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2 & 1))])
                        corners |= 1u << i;
                auto const& table = CubeTable::get();
                for (auto const& edges : table.triangles(static_cast<std::uint8_t>(corners))) {
                    Corners triangle;
                    for (std::size_t k = 0; k < 3; ++k) {
                        auto const& [axis, corner] = table.edge(edges[k]);
                        triangle[k] = { float(x + (corner & 1)), float(y + (corner >> 1 & 1)),
                                        float(z + (corner >> 2 & 1)) };
                        triangle[k][static_cast<std::size_t>(axis)] += 0.5f;
                    }
                    triangles.push_back(triangle);
                }
            }
    EXPECT_GT(triangles.size(), 5000u);
    EXPECT_EQ(count_bad_edges(triangles), 0u);
}

TEST(ClosedShell, AForkWithALeafIsOneShell)
{
    auto const parts = solid_parts(fork(), { .least_thickness_mm = 1 });
    auto const mesh = closed_shell(parts).value();
    EXPECT_EQ(count_bad_edges(corners_of(mesh)), 0u);
    EXPECT_EQ(count_surfaces(mesh), 1u);
    // Less than that of the parts, which overlap; but most of it. Tubes have corners.
    double const of_parts = volume_mm3(closed_surfaces(parts));
    EXPECT_LT(volume_mm3(mesh), 1.06 * of_parts);
    EXPECT_GT(volume_mm3(mesh), 0.9 * of_parts);
    EXPECT_NEAR(box_mm(mesh).min().z(), 0, 0.1) << "the base is flat, at the ground";
}

TEST(ClosedShell, HasTheRadiusOfTheBranch)
{
    auto const box = box_mm(shell(single_axis(3, 10, 10), { .least_thickness_mm = 2 }));
    EXPECT_NEAR(box.sizes().x(), 20, 0.1);
    EXPECT_NEAR(box.sizes().y(), 20, 0.1);
    EXPECT_NEAR(box.sizes().z(), 160, 0.2) << "three segments of 50 mm and the dome at the tip";
}

TEST(ClosedShell, AFruitIsFull)
{
    Plant plant;
    plant.materials = { Material { .kind = Material::Kind::Solid } };
    plant.organ_shapes = { { .kind = OrganShape::Kind::Ball, .length_mm = 20, .width_mm = 20 } };
    plant.organs = { Organ {} };
    auto const mesh = shell(plant, { .least_thickness_mm = 1 });
    EXPECT_EQ(count_surfaces(mesh), 1u);
    EXPECT_NEAR(volume_mm3(mesh), volume_mm3(closed_surfaces(solid_parts(plant, {}))), 40);
}

TEST(ClosedShell, SaysWhichThicknessWouldBeEnough)
{
    auto const refused = closed_shell(solid_parts(fork(), { .least_thickness_mm = 0.01 }));
    ASSERT_FALSE(refused);
    auto const& message = refused.error().message;
    std::string const before = "give a least thickness of ";
    auto const place = message.find(before);
    ASSERT_NE(place, std::string::npos) << message;
    double const enough = std::stod(message.substr(place + before.size()));
    EXPECT_LT(enough, 1);
    EXPECT_TRUE(closed_shell(solid_parts(fork(), { .least_thickness_mm = enough })));
}

RC_GTEST_PROP(ClosedShell, IsClosedAndTheSameOnAnyNumberOfThreads, ())
{
    auto const plant = *random_plants();
    double const size = (bounds(plant).max_mm - bounds(plant).min_mm).maxCoeff();
    SolidOptions const options { .least_thickness_mm = std::max(size / 36, 0.01) };
    auto const make = [&] { return shell(plant, options); };
    auto const single = on_threads(1, make);
    RC_ASSERT(count_bad_edges(corners_of(single)) == 0u);
    auto const twofold = on_threads(2, make);
    RC_ASSERT(single.positions_mm == twofold.positions_mm);
    RC_ASSERT(single.materials == twofold.materials);
    RC_ASSERT(single.triangles == twofold.triangles);
    auto const make_parts = [&] { return closed_surfaces(solid_parts(plant, options)); };
    auto const parts = on_threads(1, make_parts);
    RC_ASSERT(count_bad_edges(corners_of(parts)) == 0u);
    RC_ASSERT(parts.positions_mm == on_threads(2, make_parts).positions_mm);
}

} // namespace
} // namespace tractus::mesh
