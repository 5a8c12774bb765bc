#include "engine/mesh/make_mesh.h"

#include "engine/mesh/mesh_plan.h"
#include "engine/mesh/spine.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/sample_plants.h"
#include "tests/engine/plant/small_plant.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <vector>

namespace tractus::mesh {
namespace {

// All tubes have eight sides, so that triangles can be counted by hand.
constexpr MeshOptions kEightSides { .min_sides = 8, .max_sides = 8, .subdivision = 0, .collar = 0 };

double distance_to_axis(Plant const& plant, Axis const& axis, Vec3 const& point)
{
    auto const nodes = plant.positions(axis);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        Vec3 const step = nodes[i] - nodes[i - 1];
        double const share
            = std::clamp((point - nodes[i - 1]).dot(step) / step.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (point - nodes[i - 1] - share * step).norm());
    }
    return nearest;
}

TEST(MakeMesh, MakesNothingOfAnEmptyPlant)
{
    EXPECT_EQ(make_mesh({}).triangle_count(), 0u);
}

TEST(MakeMesh, MakesNothingWhenItIsGivenUp)
{
    auto const plant = sample_tree(1);
    std::stop_source asked;
    EXPECT_EQ(make_mesh(plant, {}, asked.get_token()).triangle_count(),
              make_mesh(plant).triangle_count());
    asked.request_stop();
    EXPECT_TRUE(MeshPlan(plant, {}, asked.get_token()).surfaces().empty());
    EXPECT_EQ(make_mesh(plant, {}, asked.get_token()).triangle_count(), 0u);
}

TEST(MakeMesh, ClosesATubeAtBothEnds)
{
    for (double const tip_mm : { 10.0, 3.0, 0.0 }) {
        auto const mesh = make_mesh(single_axis(3, 10, tip_mm));
        ASSERT_EQ(mesh.surfaces.size(), 1u);
        expect_sound(mesh.surfaces[0]);
        EXPECT_EQ(open_edge_count(mesh.surfaces[0]), 0u) << tip_mm;
        EXPECT_EQ(inside_out_count(mesh.surfaces[0]), 0u) << tip_mm;
    }
}

TEST(MakeMesh, HasTheVolumeOfATruncatedConeAndHalfABall)
{
    MeshOptions const fine { .min_sides = 64, .max_sides = 64 };
    auto const mesh = make_mesh(single_axis(3, 20, 10), fine);
    double const cone = kPi * 150 / 3 * (20 * 20 + 20 * 10 + 10 * 10);
    double const half_ball = 2 * kPi / 3 * 1000;
    EXPECT_NEAR(volume_mm3(mesh.surfaces[0]), cone + half_ball, 0.01 * cone);
}

TEST(MakeMesh, MakesTheTrianglesThatAreCountedByHand)
{
    // Triangles: three segments of 8 quads each, a ring and an apex for the dome, and 6 for the
    // base.
    EXPECT_EQ(make_mesh(single_axis(3, 10, 5), kEightSides).triangle_count(), 3 * 16 + 16 + 8 + 6u);
    // If the tip is pointed, the last segment is a cone of 8 triangles.
    EXPECT_EQ(make_mesh(single_axis(3, 10, 0), kEightSides).triangle_count(), 2 * 16 + 8 + 6u);
    // A lateral axis has no base of its own.
    auto plant = small_plant();
    plant.organs.clear();
    EXPECT_EQ(make_mesh(plant, kEightSides).triangle_count(), (3 + 2) * 16 + 2 * (16 + 8) + 6u);
}

TEST(MakeMesh, LeavesOutDomesAndBasesWhenEndsAreOpen)
{
    auto const open = [](double tip_mm) {
        auto options = kEightSides;
        options.ends = MeshOptions::Ends::Open;
        return make_mesh(single_axis(3, 10, tip_mm), options).triangle_count();
    };
    EXPECT_EQ(open(5), 3 * 16u);
    EXPECT_EQ(open(0), 2 * 16 + 8u);
}

TEST(MakeMesh, GivesThickAxesMoreSidesThanThinOnes)
{
    auto const thick_only = make_mesh(single_axis(1, 50, 50)).triangle_count();
    auto plant = single_axis(1, 50, 50);
    Random random({});
    append_axis(plant,
                { .base_mm = { 0, 0, 50 },
                  .direction = Vec3::UnitX(),
                  .segment_count = 1,
                  .radius_mm = 0.5,
                  .tip_radius_mm = 0.5,
                  .parent_segment = 0,
                  .parent_axis = 0,
                  .order = 1 },
                random);
    EXPECT_EQ(make_mesh(plant).triangle_count(), thick_only + 5 * 2 + 5);
}

TEST(MakeMesh, IsSoundForATreeAndFacesOutwards)
{
    for (std::uint64_t const seed : { 1u, 2u, 3u }) {
        auto const plant = sample_tree(seed);
        check_plant(plant);
        auto const mesh = make_mesh(plant);
        ASSERT_EQ(mesh.surfaces.size(), 1u);
        expect_sound(mesh.surfaces[0]);
        // In sharp bends, some triangles inside the tube may be inverted.
        EXPECT_LT(inside_out_count(mesh.surfaces[0]), mesh.surfaces[0].triangle_count() / 200);
    }
}

TEST(MakeMesh, NormalsLeanWithTheTaper)
{
    auto const mesh = make_mesh(single_axis(4, 20, 4));
    float const expected = 16.0f / 200; // Slope of the radius along the axis.
    auto const& tubes = mesh.surfaces[0];
    for (std::size_t i = 0; i < tubes.normals.size(); ++i) {
        auto const& position = tubes.positions_mm[i];
        auto const& normal = tubes.normals[i];
        if (position.z() < 1 || position.z() > 199)
            continue; // Skips the vertices of the base and the dome.
        EXPECT_NEAR(normal.z() / Vec2f(normal.x(), normal.y()).norm(), expected, 0.01);
        EXPECT_GT(normal.head<2>().dot(position.head<2>()), 0);
    }
}

TEST(MakeMesh, LateralBasesLieInsideTheirParent)
{
    auto const plant = sample_tree(4);
    SpineBuffers room;
    for (auto const& axis : std::span(plant.axes).subspan(1)) {
        auto const spine = trace_spine(plant, axis, {}, 90, room);
        ASSERT_FALSE(spine.stations.empty());
        auto const& base = spine.stations.front();
        auto const parent_radius = plant.node_radius_mm[nodes_of(plant, axis.parent_segment).tip];
        double const off_axis
            = distance_to_axis(plant, plant.axes[axis.parent_axis], base.center_mm);
        ASSERT_LE(off_axis + base.radius_mm, parent_radius * 1.0001);
        EXPECT_FALSE(spine.closed_base);
    }
}

TEST(MakeMesh, ClosesTheBaseOfAnAxisThatStandsBesideItsParent)
{
    auto plant = small_plant();
    for (NodeId node = 4; node < 7; ++node)
        plant.node_position_mm[node].x() += 20;
    EXPECT_EQ(open_edge_count(make_mesh(plant).surfaces[0]), 0u);
}

TEST(MakeMesh, AContinuedLimbStartsAsWideAsItsParentEnds)
{
    auto plant = single_axis(2, 20, 10);
    Random random({});
    append_axis(plant,
                { .base_mm = { 0, 0, 100 },
                  .direction = { 0.3, 0, 1 },
                  .segment_count = 2,
                  .radius_mm = 8,
                  .tip_radius_mm = 4,
                  .parent_segment = 1,
                  .parent_axis = 0,
                  .order = 1 },
                random);
    auto const mesh = make_mesh(plant, { .min_sides = 16, .max_sides = 16 });
    float widest = 0;
    for (auto const& position : mesh.surfaces[0].positions_mm)
        if (std::abs(position.z() - 100) < 1e-3f)
            widest = std::max(widest, position.head<2>().norm());
    EXPECT_NEAR(widest, 10, 1e-3);
}

TEST(MakeMesh, CollarsNeverPassTheParentsRadius)
{
    auto plant = single_axis(2, 10, 10);
    Random random({});
    append_axis(plant,
                { .base_mm = { 0, 0, 50 },
                  .direction = Vec3::UnitX(),
                  .segment_count = 3,
                  .radius_mm = 9,
                  .tip_radius_mm = 3,
                  .parent_segment = 0,
                  .parent_axis = 0,
                  .order = 1 },
                random);
    auto const mesh = make_mesh(plant, { .collar = 5 });
    for (auto const& position : mesh.surfaces[0].positions_mm)
        if (position.x() > 10.01f) {
            EXPECT_LE(Vec2f(position.y(), position.z() - 50).norm(), 10.001f);
        }
}

// Returns a thick upright trunk with a branch that leaves it at an angle.
Plant forked_trunk(double angle_deg)
{
    auto plant = single_axis(4, 30, 30);
    Random random({});
    double const angle = radians(angle_deg);
    append_axis(plant,
                { .base_mm = { 0, 0, 100 },
                  .direction = { std::sin(angle), 0, std::cos(angle) },
                  .segment_count = 4,
                  .radius_mm = 10,
                  .tip_radius_mm = 8,
                  .parent_segment = 1,
                  .parent_axis = 0,
                  .order = 1 },
                random);
    return plant;
}

TEST(MakeMesh, BranchesMeetTheirParentInASaddle)
{
    for (double const angle_deg : { 40.0, 60.0, 90.0, 120.0 }) {
        auto const plant = forked_trunk(angle_deg);
        SpineBuffers room;
        auto const spine = trace_spine(plant, plant.axes[1], {}, 30, room);
        ASSERT_GT(spine.saddle.parent_radius_mm, 0);
        auto const mesh = make_mesh(plant, { .min_sides = 16, .max_sides = 16 });
        auto surface = mesh.surfaces[0];
        // Triangles inside the trunk are not seen.
        std::vector<std::uint32_t> seen;
        for (std::size_t i = 0; i < surface.indices.size(); i += 3) {
            auto const* const corners = &surface.indices[i];
            if (std::all_of(corners, corners + 3, [&](std::uint32_t corner) {
                    return surface.positions_mm[corner].head<2>().norm() > 29.9f;
                }))
                seen.insert(seen.end(), corners, corners + 3);
        }
        surface.indices.assign(seen.begin(), seen.end());
        EXPECT_GT(surface.triangle_count(), 100u);
        EXPECT_EQ(inside_out_count(surface), 0u);
        // The branch's corners on the trunk's surface have the trunk's normals.
        std::size_t on_trunk = 0;
        Vec3f const along
            = Vec3(std::sin(radians(angle_deg)), 0, std::cos(radians(angle_deg))).cast<float>();
        for (std::size_t i = 0; i < surface.positions_mm.size(); ++i) {
            auto const& position = surface.positions_mm[i];
            Vec3f const from_base = position - Vec3f(0, 0, 100);
            float const beside = (from_base - along * along.dot(from_base)).norm();
            bool const is_of_branch = std::abs(beside - 14.2f) < 0.5f && from_base.dot(along) > 5;
            if (!is_of_branch || std::abs(position.head<2>().norm() - 30) > 0.05f)
                continue;
            ++on_trunk;
            // Normals in the sharp corner above a steep branch lean less.
            float const least = angle_deg == 90 ? 0.99f : 0.75f;
            EXPECT_GT(surface.normals[i].head<2>().dot(position.head<2>().normalized()), least);
        }
        EXPECT_GE(on_trunk, 16u) << angle_deg;
    }
}

TEST(MakeMesh, ASaddleIsTheSameWhicheverWayTheBranchPoints)
{
    auto const reference = make_mesh(forked_trunk(60));
    auto turned = forked_trunk(60);
    Quat const turn(Eigen::AngleAxisd(radians(77), Vec3::UnitZ()));
    for (auto& node : turned.node_position_mm)
        node = turn * node;
    auto const mesh = make_mesh(turned);
    auto const box_of = [](Mesh const& made, Quat const& back) {
        Bounds box;
        for (auto const& position : made.surfaces[0].positions_mm)
            box.add(back * position.cast<double>());
        return box;
    };
    auto const before = box_of(reference, Quat::Identity());
    auto const after = box_of(mesh, turn.conjugate());
    // The corners of a tube turn against the tube, so they reach a little more or less far.
    EXPECT_NEAR(before.max_mm.x(), after.max_mm.x(), 0.2);
    EXPECT_NEAR(before.max_mm.z(), after.max_mm.z(), 0.2);
}

TEST(MakeMesh, ATrunkHasRidgesAtTheGroundOnly)
{
    auto plant = single_axis(4, 100, 80);
    plant.root_flare = { .ridges = 5, .depth = 0.3f, .turn = 1 };
    auto const mesh = make_mesh(plant);
    auto const& surface = mesh.surfaces[0];
    EXPECT_EQ(open_edge_count(surface), 0u);
    EXPECT_EQ(inside_out_count(surface), 0u);
    // Radii at the ground, in the order of their directions.
    std::map<double, double> ground;
    double above_least = 1e9;
    double above_most = 0;
    for (auto const& position : surface.positions_mm) {
        double const radius = position.head<2>().norm();
        if (position.z() == 0 && radius > 1)
            ground[std::atan2(position.y(), position.x())] = radius;
        if (std::abs(position.z() - 180) < 20) {
            above_least = std::min(above_least, radius);
            above_most = std::max(above_most, radius);
        }
    }
    std::vector<double> radii;
    double sum = 0;
    for (auto const& [angle, radius] : ground) {
        radii.push_back(radius);
        sum += radius;
    }
    int peaks = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        auto const count = radii.size();
        if (radii[i] > radii[(i + 1) % count] && radii[i] >= radii[(i + count - 1) % count])
            ++peaks;
    }
    EXPECT_EQ(peaks, 5);
    EXPECT_NEAR(sum / static_cast<double>(radii.size()), 100, 3);
    EXPECT_GT(std::ranges::max(radii), 120);
    EXPECT_LT(std::ranges::min(radii), 85);
    EXPECT_LT(above_most / above_least, 1.2);
}

TEST(MakeMesh, ThinStemsHaveNoRidges)
{
    auto plant = single_axis(4, 100, 80);
    Random random({});
    append_axis(plant, { .base_mm = { 500, 0, 0 }, .segment_count = 2, .radius_mm = 20 }, random);
    plant.root_flare = { .ridges = 5, .depth = 0.3f };
    auto const mesh = make_mesh(plant);
    for (auto const& position : mesh.surfaces[0].positions_mm)
        if (position.x() > 300) {
            EXPECT_LE((position.head<2>() - Vec2f(500, 0)).norm(), 20.01f);
        }
}

TEST(MakeMesh, RoundsBendsAndKeepsNodes)
{
    Plant plant = single_axis(2, 5, 5);
    plant.node_position_mm[2] = { 35, 0, 85 };
    auto const straight = make_mesh(plant, { .subdivision = 0 });
    auto const round = make_mesh(plant, { .subdivision = 4 });
    EXPECT_GT(round.triangle_count(), straight.triangle_count());
    expect_sound(round.surfaces[0]);
    EXPECT_EQ(inside_out_count(round.surfaces[0]), 0u);
    EXPECT_EQ(open_edge_count(round.surfaces[0]), 0u);
}

TEST(MakeMesh, SurvivesSharpTurnsAndCoincidingNodes)
{
    Plant plant = single_axis(6, 5, 0);
    plant.node_position_mm = { { 0, 0, 0 },  { 0, 0, 50 },  { 0, 0, 50 }, { 0, 0, 0 },
                               { 50, 0, 0 }, { 50, 50, 0 }, { 50, 50, 0 } };
    plant.node_radius_mm = { 5, 0, 0, 5, 3, 2, 0 };
    for (int const subdivision : { 0, 4 }) {
        auto const mesh = make_mesh(plant, { .subdivision = subdivision });
        expect_sound(mesh.surfaces[0]);
        EXPECT_EQ(open_edge_count(mesh.surfaces[0]), 0u);
    }
    for (auto& position : plant.node_position_mm)
        position = { 1, 2, 3 };
    EXPECT_EQ(make_mesh(plant).triangle_count(), 0u);
}

TEST(MakeMesh, KeepsTheWidthThroughASharpBend)
{
    Plant plant = single_axis(2, 5, 5);
    plant.node_position_mm[2] = { 100, 0, 50 };
    auto const mesh = make_mesh(plant, { .min_sides = 32, .max_sides = 32, .subdivision = 0 });
    float outermost = 0;
    for (auto const& position : mesh.surfaces[0].positions_mm)
        outermost
            = std::max(outermost, (position - Vec3f(0, 0, 50)).dot(Vec3f(-1, 0, 1).normalized()));
    EXPECT_NEAR(outermost, 5, 0.2); // A pinched corner would be much thinner.
}

TEST(MakeMesh, JoinsMaterialsWithoutAGap)
{
    auto plant = single_axis(4, 10, 10);
    plant.materials.push_back({ .name = "young", .kind = Material::Kind::Stem });
    plant.segment_material = { 0, 0, 1, 1 };
    auto const mesh = make_mesh(plant);
    ASSERT_EQ(mesh.surfaces.size(), 2u);
    TriangleMesh both = mesh.surfaces[0];
    auto const& other = mesh.surfaces[1];
    auto const base = static_cast<std::uint32_t>(both.positions_mm.size());
    both.positions_mm.insert(both.positions_mm.end(), other.positions_mm.begin(),
                             other.positions_mm.end());
    for (auto const index : other.indices)
        both.indices.push_back(base + index);
    EXPECT_EQ(open_edge_count(both), 0u);
}

TEST(MakeMesh, TextureIsSeamlessAndHasOneScale)
{
    auto const mesh = make_mesh(single_axis(4, 10, 10), kEightSides);
    auto const& tubes = mesh.surfaces[0];
    for (std::size_t ring = 0; ring < 5; ++ring) {
        std::size_t const first = 8 + 9 * ring;
        EXPECT_EQ(tubes.positions_mm[first], tubes.positions_mm[first + 8]);
        EXPECT_EQ(tubes.texture_coordinates[first].x(), 0);
        EXPECT_EQ(tubes.texture_coordinates[first + 8].x(), 1);
        // Each segment is 50 mm long, and the circumference is 20 pi mm.
        EXPECT_NEAR(tubes.texture_coordinates[first].y(),
                    static_cast<double>(ring) * 50 / (20 * kPi), 1e-5);
    }
}

TEST(MakeMesh, PlacesOrgansAsThePlantSays)
{
    auto plant = small_plant();
    Quat const turn(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    plant.organs[0].orientation = turn;
    plant.organs[0].scale = { 1, 2, 3 };
    plant.organ_shapes.push_back({ .name = "unused", .material = 1 });
    auto const mesh = make_mesh(plant);
    ASSERT_EQ(mesh.organs.size(), 1u);
    ASSERT_EQ(mesh.organs[0].instances.size(), 1u);
    auto const& instance = mesh.organs[0].instances[0];
    EXPECT_EQ(instance.translation_mm, Vec3f(100, 0, 100));
    EXPECT_TRUE(instance.rotation.isApprox(turn.cast<float>()));
    EXPECT_EQ(instance.scale, Vec3f(1, 2, 3));
    EXPECT_EQ(mesh.organs[0].prototype.material, 1);
}

TEST(MakeMesh, FillsConcavePolygons)
{
    auto plant = single_axis(1, 1, 1);
    plant.materials.push_back({ .name = "leaf", .kind = Material::Kind::Leaf });
    // An arrowhead in the plane y = 0 that faces -y, with an area of 1,000 mm².
    plant.polygon_vertices_mm = { { 0, 0, 0 }, { 50, 0, -20 }, { 0, 0, 40 }, { -50, 0, -20 } };
    plant.polygons = { { .first_vertex = 0, .vertex_count = 4, .material = 1 } };
    auto const mesh = make_mesh(plant);
    ASSERT_EQ(mesh.surfaces.size(), 2u);
    auto const& polygon = mesh.surfaces[1];
    expect_sound(polygon);
    ASSERT_EQ(polygon.triangle_count(), 2u);
    Vec3 area = Vec3::Zero();
    double magnitude = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        area += area_vector(polygon, i) / 2;
        magnitude += area_vector(polygon, i).norm() / 2;
    }
    EXPECT_NEAR(area.norm(), 2000, 1e-3);
    EXPECT_NEAR(magnitude, 2000, 1e-3); // No triangle may lie outside the outline of the polygon.
    EXPECT_GT(area.dot(polygon.normals[0].cast<double>()), 0);
}

TEST(MakeMesh, SkipsAPolygonWithoutArea)
{
    auto plant = single_axis(1, 1, 1);
    plant.polygon_vertices_mm = { { 0, 0, 0 }, { 10, 0, 0 }, { 20, 0, 0 } };
    plant.polygons = { { .first_vertex = 0, .vertex_count = 3, .material = 0 } };
    EXPECT_EQ(make_mesh(plant).triangle_count(), make_mesh(single_axis(1, 1, 1)).triangle_count());
}

} // namespace
} // namespace tractus::mesh
