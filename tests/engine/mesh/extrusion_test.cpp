#include "engine/mesh/make_mesh.h"
#include "tests/engine/mesh/mesh_checks.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::mesh {
namespace {

// Returns a square of side 2 about the origin. It begins in the middle of its side at x = 1.
Contour square()
{
    Contour contour;
    contour.name = "square";
    for (std::size_t i = 0; i <= Contour::kSteps; ++i) {
        float const t = 8 * static_cast<float>(i) / static_cast<float>(Contour::kSteps);
        Vec3f point(1, t, 0);
        if (t > 7)
            point = { 1, t - 8, 0 };
        else if (t > 5)
            point = { t - 6, -1, 0 };
        else if (t > 3)
            point = { -1, 4 - t, 0 };
        else if (t > 1)
            point = { 2 - t, 1, 0 };
        contour.points.push_back(point);
    }
    return contour;
}

// Returns an open contour, a ribbon with a width of 2 along y.
Contour ribbon()
{
    Contour contour;
    contour.name = "ribbon";
    contour.closed = false;
    for (std::size_t i = 0; i <= Contour::kSteps; ++i)
        contour.points.emplace_back(
            0, 2 * static_cast<float>(i) / static_cast<float>(Contour::kSteps) - 1, 0);
    return contour;
}

// Returns a straight axis of 100 mm with a node in its middle. Its section is the contour, scaled
// by 10 mm.
Plant extruded(Contour const& contour)
{
    Plant plant;
    plant.materials = { Material {} };
    plant.axes = { Axis { .first_node = 0, .first_segment = 0, .segment_count = 2 } };
    plant.node_position_mm = { { 0, 0, 0 }, { 0, 0, 50 }, { 0, 0, 100 } };
    plant.node_radius_mm = { 10, 10, 10 };
    plant.segment_material = { 0, 0 };
    plant.contours = { contour };
    NodeSection section;
    section.contour = 0;
    section.normal = Vec3f::UnitX();
    section.sides = 16;
    plant.node_section = { section, section, section };
    return plant;
}

TriangleMesh mesh_of(Plant const& plant)
{
    check_plant(plant);
    auto const mesh = make_mesh(plant);
    EXPECT_EQ(mesh.surfaces.size(), 1u);
    if (mesh.surfaces.empty())
        return {};
    expect_sound(mesh.surfaces[0]);
    EXPECT_EQ(inside_out_count(mesh.surfaces[0]), 0u);
    return mesh.surfaces[0];
}

TEST(Extrusion, FillsAClosedOutline)
{
    auto const mesh = mesh_of(extruded(square()));
    EXPECT_EQ(open_edge_count(mesh), 0u);
    EXPECT_NEAR(volume_mm3(mesh), 20 * 20 * 100, 1);
}

TEST(Extrusion, GivesASheetTwoSides)
{
    auto const mesh = mesh_of(extruded(ribbon()));
    // The factors are both sides of the ribbon, segments, triangles of a quad, and strips.
    EXPECT_EQ(mesh.triangle_count(), 2u * 2 * 2 * 16);
    EXPECT_EQ(open_edge_count(mesh), 0u);
    for (auto const& position : mesh.positions_mm)
        EXPECT_NEAR(position.x(), 0, 1e-4f); // The ribbon lies across its normal, which is x.
}

TEST(Extrusion, TwistsWithItsSections)
{
    auto plant = extruded(square());
    plant.node_section[2].normal = Vec3f(1, 1, 0).normalized();
    auto const mesh = mesh_of(plant);
    double widest_mm = 0;
    for (auto const& position : mesh.positions_mm)
        if (position.z() > 99)
            widest_mm = std::max<double>(widest_mm, position.x());
    EXPECT_NEAR(widest_mm, 10 * std::sqrt(2), 1e-3); // Now a corner of the square points to x.
}

TEST(Extrusion, PassesFromOneOutlineToAnother)
{
    auto plant = extruded(square());
    for (auto& section : plant.node_section)
        section.next_contour = kNoContour; // A section without a contour is a circle.
    plant.node_section[1].share = 0.5f;
    plant.node_section[2].share = 1;
    auto const mesh = mesh_of(plant);
    EXPECT_EQ(open_edge_count(mesh), 0u);
    double square_mm = 0;
    double circle_mm = 0;
    for (auto const& position : mesh.positions_mm) {
        double const radius = position.head<2>().norm();
        if (position.z() < 1)
            square_mm = std::max(square_mm, radius);
        else if (position.z() > 99)
            circle_mm = std::max(circle_mm, radius);
    }
    EXPECT_NEAR(square_mm, 10 * std::sqrt(2), 1e-3);
    EXPECT_NEAR(circle_mm, 10, 1e-3);
}

TEST(Extrusion, HasTheSidesThatAreAskedFor)
{
    auto plant = extruded(ribbon());
    for (auto& section : plant.node_section)
        section.sides = 4;
    EXPECT_EQ(mesh_of(plant).triangle_count(), 2u * 2 * 2 * 4);
    auto const coarse = make_mesh(extruded(ribbon()), { .min_sides = 3, .max_sides = 8 });
    // Half the fineness gives half as many sides.
    EXPECT_EQ(coarse.triangle_count(), 2u * 2 * 2 * 8);
}

TEST(Extrusion, SurvivesNodesThatCoincideAndMaterialsThatChange)
{
    auto plant = extruded(square());
    plant.materials.push_back(Material { .name = "green" });
    plant.segment_material[1] = 1;
    plant.node_position_mm[1] = { 5, 0, 40 };
    auto const mesh = make_mesh(plant);
    ASSERT_EQ(mesh.surfaces.size(), 2u);
    for (auto const& surface : mesh.surfaces) {
        expect_sound(surface);
        EXPECT_EQ(inside_out_count(surface), 0u);
    }
    plant.node_position_mm = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
    EXPECT_EQ(make_mesh(plant).triangle_count(), 0u);
}

} // namespace
} // namespace tractus::mesh
