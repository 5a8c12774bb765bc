#include "engine/methods/self_organising/sag.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::self_organising {
namespace {

// Returns a horizontal branch along x with the given number and length of internodes, and without
// laterals.
GrowingTree straight_branch(int internodes, double length_mm)
{
    auto tree = plant_seed(Vec3::Zero(), Vec3::UnitX());
    for (int i = 0; i < internodes; ++i) {
        tree.links.back().main = static_cast<std::uint32_t>(tree.size());
        tree.links.push_back({ .parent = static_cast<std::uint32_t>(i),
                               .order = 1,
                               .step = 1,
                               .rank = static_cast<std::uint32_t>(i + 1),
                               .axis = 1 });
        tree.places.push_back(
            { Vec3(length_mm * (i + 1) / internodes, 0, 0), Vec3::UnitX(), Vec3::UnitY() });
        tree.dead_wood.push_back(0);
        tree.bent_by.push_back(Vec3::Zero());
    }
    tree.step = 2;
    return tree;
}

// The end of a uniform cantilever sinks by w L^4 / (8 E I), and turns by w L^3 / (6 E I).
TEST(Sag, BendsARodAsEulerAndBernoulliSay)
{
    constexpr double kLength_mm = 1000;
    constexpr double kDiameter_mm = 12;
    auto tree = straight_branch(200, kLength_mm);
    SagLaws const laws { .leaf_kg = 0 };
    std::vector<double> const diameters(tree.size(), kDiameter_mm);
    sag(tree, diameters, laws);
    double const d = kDiameter_mm / 1000;
    double const weight_n_per_m = laws.density_kg_per_m3 * 9.81 * kPi / 4 * d * d;
    double const rigidity = laws.stiffness_gpa * 1e9 * kPi * d * d * d * d / 64;
    double const sinks_mm = 1000 * weight_n_per_m / (8 * rigidity);
    double const turns_rad = weight_n_per_m / (6 * rigidity);
    ASSERT_GT(sinks_mm, 10);
    EXPECT_NEAR(-tree.places.back().position.z(), sinks_mm, 0.02 * sinks_mm);
    EXPECT_NEAR(-std::asin(tree.places.back().direction.z()), turns_rad, 0.02 * turns_rad);
}

TEST(Sag, KeepsLengths)
{
    auto tree = straight_branch(30, 3000);
    std::vector<double> const diameters(tree.size(), 10);
    sag(tree, diameters, { .weight = 5 });
    EXPECT_LT(tree.places.back().position.z(), -100);
    for (std::size_t i = 1; i < tree.size(); ++i) {
        Vec3 const internode = tree.places[i].position - tree.places[i - 1].position;
        EXPECT_NEAR(internode.norm(), 100, 1e-9);
        EXPECT_LT((internode / 100 - tree.places[i].direction).norm(), 1e-9);
        EXPECT_NEAR(tree.places[i].direction.dot(tree.places[i].normal), 0, 1e-9);
    }
}

TEST(Sag, SetWoodBendsOnlyByWhatComesUponIt)
{
    auto tree = straight_branch(30, 1000);
    std::vector<double> const diameters(tree.size(), 10);
    SagLaws const laws;
    set_wood(tree, diameters, laws);
    sag(tree, diameters, laws);
    EXPECT_NEAR(tree.places.back().position.z(), 0, 1e-9);
    tree.step = 1; // In step 1, the internodes still carry leaves, whose weight is added.
    sag(tree, diameters, laws);
    EXPECT_LT(tree.places.back().position.z(), -1);
}

TEST(Sag, TheTrunkStands)
{
    auto tree = straight_branch(30, 1000);
    for (auto& node : tree.links)
        node.order = 0;
    sag(tree, std::vector<double>(tree.size(), 3), { .weight = 20 });
    EXPECT_EQ(tree.places.back().position.z(), 0);
}

TEST(Sag, AnUprightBranchStands)
{
    auto tree = straight_branch(30, 1000);
    for (auto& place : tree.places) {
        place.position = Vec3(0, 0, place.position.x());
        place.direction = Vec3::UnitZ();
    }
    sag(tree, std::vector<double>(tree.size(), 3), { .weight = 20 });
    EXPECT_NEAR(tree.places.back().position.z(), 1000, 1e-9);
}

} // namespace
} // namespace tractus::self_organising
