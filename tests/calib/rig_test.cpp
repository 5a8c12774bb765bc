#include "calib/rig.h"

#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

void expect_near(Vec3 const& actual, Vec3 const& expected)
{
    EXPECT_LT((actual - expected).norm(), 1e-9)
        << actual.transpose() << " is not " << expected.transpose();
}

TEST(Rig, WorldsOriginIsUnderTheTabletsCentre)
{
    Rig const rig { .tablet_size_mm = { 200, 100 } };
    expect_near(T_world_tablet(rig) * Vec3(100, 50, 0), Vec3(0, 0, 0));
    expect_near(T_world_tablet(rig) * Vec3(0, 0, 30), Vec3(-100, -50, 30));
}

TEST(Rig, TabletTurnsCounterclockwiseAboutItsCentre)
{
    Rig const rig { .tablet_size_mm = { 200, 100 }, .rotation_deg = 90 };
    expect_near(T_world_tablet(rig) * Vec3(200, 50, 7), Vec3(0, 100, 7));
    expect_near(T_world_tablet(rig) * Vec3(100, 100, 7), Vec3(-50, 0, 7));
}

TEST(Rig, CarriageDriftsAsItRises)
{
    Rig const rig { .tablet_size_mm = { 200, 100 },
                    .rotation_deg = 90,
                    .travel_shear = { 0.02, -0.01 } };
    expect_near(T_world_tablet(rig) * Vec3(100, 50, 300), Vec3(6, -3, 300));
}

} // namespace
} // namespace tractus::calib
