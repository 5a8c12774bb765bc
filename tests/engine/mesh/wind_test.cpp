#include "engine/mesh/wind.h"

#include "engine/mesh/level_of_detail.h"
#include "engine/mesh/mesh_plan.h"
#include "tests/engine/mesh/random_plants.h"
#include "tests/engine/mesh/sample_plants.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>
#include <vector>

namespace tractus::mesh {
namespace {

// A surface with the data that wind shaders need.
struct WindySurface {
    TriangleMesh mesh;
    std::vector<WindVertex> wind;
};

WindySurface first_surface(Plant const& plant, WindKey const& key)
{
    MeshPlan const plan(plant, {});
    auto const& planned = plan.surfaces()[0];
    WindySurface surface { make_mesh(plant).surfaces.at(0), {} };
    for (std::size_t piece = 0; piece < planned.piece_count(); ++piece) {
        std::vector<WindVertex> of_piece(planned.extent_of(piece).vertices);
        plan.make_wind(planned, piece, key, of_piece);
        surface.wind.insert(surface.wind.end(), of_piece.begin(), of_piece.end());
    }
    return surface;
}

TEST(Wind, BendRisesFromTheBaseOfAnAxisToItsTip)
{
    // The axis leads along +z and is 400 mm long.
    auto const [mesh, wind] = first_surface(single_axis(8, 20, 5), {});
    ASSERT_EQ(wind.size(), mesh.positions_mm.size());
    for (std::size_t i = 0; i < wind.size(); ++i) {
        EXPECT_EQ(wind[i].pivot_mm, Vec3f(0, 0, 0));
        EXPECT_EQ(wind[i].axis, Vec3f(0, 0, 1));
        EXPECT_EQ(wind[i].level, 0);
        EXPECT_NEAR(wind[i].bend, std::min(1.0f, mesh.positions_mm[i].z() / 400), 1e-5f);
    }
}

TEST(Wind, PivotsAreTheBasesOfAxesAndLevelsTheirOrders)
{
    auto const plant = sample_tree(1);
    auto const [mesh, wind] = first_surface(plant, {});
    ASSERT_EQ(wind.size(), mesh.positions_mm.size());
    for (auto const& vertex : wind) {
        EXPECT_NEAR(vertex.axis.norm(), 1, 1e-5f);
        bool const is_base
            = std::any_of(plant.axes.begin(), plant.axes.end(), [&](Axis const& axis) {
                  return static_cast<float>(axis.order) == vertex.level
                      && plant.positions(axis)[0].cast<float>() == vertex.pivot_mm;
              });
        ASSERT_TRUE(is_base);
        ASSERT_GE(vertex.bend, 0);
        ASSERT_LE(vertex.bend, 1);
    }
}

TEST(Wind, EachBranchOfEachPlantHasItsOwnPhase)
{
    auto const plant = sample_tree(2);
    auto const phases = [&](WindKey const& key) {
        std::vector<float> all;
        for (auto const& axis : plant.axes)
            all.push_back(wind_of(plant, axis, key).phase);
        return all;
    };
    auto const first = phases({ 1, 0 });
    // Phases have 24 bits, so two of the 223 may be equal by chance.
    EXPECT_GE(std::set(first.begin(), first.end()).size(), plant.axes.size() - 1);
    EXPECT_GE(*std::min_element(first.begin(), first.end()), 0);
    EXPECT_LT(*std::max_element(first.begin(), first.end()), 1);
    EXPECT_EQ(phases({ 1, 0 }), first);
    EXPECT_NE(phases({ 2, 0 })[0], first[0]);
    EXPECT_NE(phases({ 1, 1 })[0], first[0]);
}

TEST(Wind, ABranchKeepsItsPhaseFromAfar)
{
    auto const plant = sample_tree(3);
    auto const coarse = coarser_plant(plant, {}, 0.1);
    ASSERT_LT(coarse.axes.size(), plant.axes.size());
    for (auto const& axis : coarse.axes) {
        auto const now = wind_of(coarse, axis, { 1, 0 });
        auto const before
            = std::find_if(plant.axes.begin(), plant.axes.end(), [&](Axis const& whole) {
                  return plant.positions(whole).back() == coarse.positions(axis).back();
              });
        ASSERT_NE(before, plant.axes.end());
        EXPECT_EQ(now.phase, wind_of(plant, *before, { 1, 0 }).phase);
    }
}

TEST(Wind, OrgansMoveWithThePlaceWhereTheyStand)
{
    auto const plant = sample_tree(4);
    auto const& axis = plant.axes.back();
    auto const wind
        = [&](std::uint32_t segment) { return wind_at(plant, axis.first_segment + segment, {}); };
    EXPECT_EQ(wind(0).pivot_mm, plant.positions(axis)[0].cast<float>());
    EXPECT_EQ(wind(0).phase, wind_of(plant, axis, {}).phase);
    EXPECT_GT(wind(0).bend, 0);
    for (std::uint32_t i = 1; i < axis.segment_count; ++i)
        EXPECT_GT(wind(i).bend, wind(i - 1).bend);
    EXPECT_EQ(wind(axis.segment_count - 1).bend, 1);
    // The organ is on the ground, so it does not bend.
    EXPECT_EQ(wind_at(plant, kNone, {}).bend, 0);
}

RC_GTEST_PROP(Wind, IsThereForEveryVertexWhateverThePlant, ())
{
    auto const plant = *random_plants();
    MeshPlan const plan(plant, {});
    for (auto const& surface : plan.surfaces())
        for (std::size_t piece = 0; piece < surface.piece_count(); ++piece) {
            std::vector<WindVertex> wind(surface.extent_of(piece).vertices);
            for (auto& vertex : wind)
                vertex.bend = -1;
            plan.make_wind(surface, piece, {}, wind);
            for (auto const& vertex : wind) {
                RC_ASSERT(vertex.pivot_mm.allFinite() && vertex.axis.allFinite());
                RC_ASSERT(vertex.bend >= 0 && vertex.bend <= 1 + 1e-6f);
            }
        }
}

} // namespace
} // namespace tractus::mesh
