#include "engine/mesh/level_of_detail.h"

#include "engine/mesh/mesh_measures.h"
#include "tests/engine/mesh/mesh_checks.h"
#include "tests/engine/mesh/random_plants.h"
#include "tests/engine/mesh/sample_plants.h"

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <set>

namespace tractus::mesh {
namespace {

constexpr std::array<double, 5> kShares { 0.5, 0.25, 0.125, 0.0625, 0.03125 };

Mesh mesh_at(Plant const& plant, double share)
{
    return make_mesh(coarser_plant(plant, {}, share), coarser_options({}, share));
}

// Returns the sum of the volumes of the frusta between successive nodes.
double skeleton_volume_mm3(Plant const& plant)
{
    double volume = 0;
    for (auto const& axis : plant.axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            NodeId const node = axis.first_node + i;
            double const a = plant.node_radius_mm[node];
            double const b = plant.node_radius_mm[node + 1];
            volume += kPi / 3 * (a * a + a * b + b * b)
                * (plant.node_position_mm[node + 1] - plant.node_position_mm[node]).norm();
        }
    return volume;
}

// Returns the area of the leaves of the plant, counting both sides.
double organ_area_mm2(Mesh const& mesh)
{
    double area = 0;
    for (auto const& organ : mesh.organs)
        // The leaves are nearly flat and perpendicular to their z axis.
        for (auto const& instance : organ.instances)
            area += double { surface_area(organ.prototype) } * instance.scale.x()
                * instance.scale.y();
    return area;
}

TEST(LevelOfDetail, HasTheShareOfTrianglesThatWasAskedFor)
{
    auto const plant = sample_tree(1);
    auto const full = static_cast<double>(make_mesh(plant).triangle_count());
    for (double const share : kShares)
        EXPECT_LE(static_cast<double>(mesh_at(plant, share).triangle_count()), share * full)
            << share;
}

TEST(LevelOfDetail, NoTwigGoesThatCouldStay)
{
    auto plant = sample_tree(1);
    // Organs are removed, since their leaf cards may need far fewer triangles than allowed.
    plant.organs.clear();
    auto const full = static_cast<double>(make_mesh(plant).triangle_count());
    int thinned = 0;
    for (double const share : kShares) {
        if (coarser_plant(plant, {}, share).axes.size() == plant.axes.size())
            continue;
        ++thinned;
        EXPECT_GE(static_cast<double>(mesh_at(plant, share).triangle_count()), 0.85 * share * full)
            << share;
    }
    EXPECT_GE(thinned, 2);
}

TEST(LevelOfDetail, BranchesKeepTheirVolume)
{
    auto const plant = sample_tree(2);
    double const volume = skeleton_volume_mm3(plant);
    for (double const share : kShares)
        EXPECT_NEAR(skeleton_volume_mm3(coarser_plant(plant, {}, share)), volume, 0.01 * volume)
            << share;
}

TEST(LevelOfDetail, LeavesKeepTheirArea)
{
    auto const plant = sample_tree(3);
    double const area = organ_area_mm2(make_mesh(plant));
    for (double const share : kShares)
        EXPECT_NEAR(organ_area_mm2(mesh_at(plant, share)), area, 0.01 * area) << share;
}

TEST(LevelOfDetail, TubesOfFewSidesKeepTheVolumeOfRoundOnes)
{
    auto const plant = single_axis(4, 10, 10);
    auto const volume = [&](int sides) {
        MeshOptions options { .min_sides = sides, .max_sides = sides };
        options.sections = MeshOptions::Sections::SameArea;
        return volume_mm3(make_mesh(plant, options).surfaces.at(0));
    };
    double const round = kPi * 10 * 10 * 4 * 50;
    EXPECT_NEAR(volume(3), round, 0.06 * round); // The volume includes the dome at the tip.
    EXPECT_NEAR(volume(8), round, 0.06 * round);
}

TEST(LevelOfDetail, KeepsShapesOfFewOrgansAsTheyAreIfAsked)
{
    auto plant = sample_tree(3);
    ASSERT_FALSE(plant.organs.empty());
    // The first organ's shape has as many organs as are kept, then one more.
    auto const organ = plant.organs.front();
    plant.organs.assign(kFewOrgans, organ);
    EXPECT_LT(coarser_plant(plant, {}, 0.5).organs.size(), kFewOrgans);
    auto const kept = coarser_plant(plant, {}, 0.5, CoarserOrgans::KeepFew);
    ASSERT_EQ(kept.organs.size(), kFewOrgans);
    EXPECT_EQ(kept.organs.front().scale, organ.scale);
    plant.organs.push_back(organ);
    EXPECT_LT(coarser_plant(plant, {}, 0.5, CoarserOrgans::KeepFew).organs.size(), kFewOrgans);
}

TEST(LevelOfDetail, TheTrunkStaysInItsPlaceAndAsThickAsItIs)
{
    auto const plant = sample_tree(4);
    auto const& trunk = plant.axes[0];
    for (double const share : kShares) {
        auto const coarse = coarser_plant(plant, {}, share);
        auto const& now = coarse.axes.at(0);
        auto const nodes = coarse.positions(now);
        EXPECT_EQ(nodes.front(), plant.positions(trunk).front());
        EXPECT_EQ(nodes.back(), plant.positions(trunk).back());
        // Each node must be a node of the plant in full detail.
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            bool found = false;
            for (std::uint32_t k = 0; k <= trunk.segment_count; ++k)
                found |= nodes[i] == plant.node_position_mm[trunk.first_node + k]
                    && coarse.node_radius_mm[now.first_node + i]
                        == plant.node_radius_mm[trunk.first_node + k];
            EXPECT_TRUE(found) << share << ' ' << i;
        }
    }
}

TEST(LevelOfDetail, WhatACoarserLevelHasAFinerOneHasToo)
{
    auto const plant = sample_tree(5);
    auto const tips = [&](double share) {
        auto const coarse = coarser_plant(plant, {}, share);
        std::set<std::array<double, 3>> places;
        for (auto const& axis : coarse.axes) {
            auto const tip = coarse.positions(axis).back();
            places.insert({ tip.x(), tip.y(), tip.z() });
        }
        return places;
    };
    auto finer = tips(1);
    for (double const share : kShares) {
        auto const coarser = tips(share);
        EXPECT_LT(coarser.size(), finer.size());
        EXPECT_TRUE(std::includes(finer.begin(), finer.end(), coarser.begin(), coarser.end()));
        finer = coarser;
    }
}

TEST(LevelOfDetail, SmallTwigsGoBeforeLimbs)
{
    auto const plant = sample_tree(6);
    auto const coarse = coarser_plant(plant, {}, 0.04);
    auto const count = [](Plant const& of, std::uint32_t order) {
        return std::count_if(of.axes.begin(), of.axes.end(),
                             [&](Axis const& axis) { return axis.order == order; });
    };
    EXPECT_EQ(count(coarse, 1), count(plant, 1));
    EXPECT_LT(2 * count(coarse, 3), count(plant, 3));
}

RC_GTEST_PROP(LevelOfDetail, IsASoundPlantWhateverThePlant, ())
{
    auto const plant = *random_plants();
    double const share = *rc::gen::element(1.0, 0.5, 0.2, 0.05, 0.001);
    auto const coarse = coarser_plant(plant, {}, share);
    check_plant(coarse);
    auto const mesh = make_mesh(coarse, coarser_options({}, share));
    for (auto const& surface : mesh.surfaces)
        expect_sound(surface);
    RC_ASSERT(coarse.axes.empty() == plant.axes.empty());
}

RC_GTEST_PROP(LevelOfDetail, IsTheSameOnAnyNumberOfThreads, ())
{
    auto const plant = *random_plants();
    auto const make = [&] { return coarser_plant(plant, {}, 0.25); };
    auto const one = on_threads(1, make);
    auto const four = on_threads(4, make);
    RC_ASSERT(one.node_position_mm == four.node_position_mm);
    RC_ASSERT(one.node_radius_mm == four.node_radius_mm);
    RC_ASSERT(one.organs.size() == four.organs.size());
    RC_ASSERT(one.polygon_vertices_mm == four.polygon_vertices_mm);
}

} // namespace
} // namespace tractus::mesh
