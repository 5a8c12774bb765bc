#include "sim/rig_geometry.h"

#include <gtest/gtest.h>

namespace tractus::sim {
namespace {

constexpr double kTolerance = 1e-9;

TEST(RigGeometry, StringIsTheHypotenuse)
{
    RigGeometry const geometry { .string_offset_mm = 300, .string_base_mm = 100 };
    EXPECT_DOUBLE_EQ(string_length_mm(geometry, 300), 500);
}

TEST(RigGeometry, PerfectCalibrationReadsTheTrueHeight)
{
    RigGeometry const geometry;
    auto const rig = true_rig(geometry);
    for (double height = 0; height <= geometry.travel_mm; height += 10) {
        double const counts = ideal_counts(geometry, height);
        EXPECT_NEAR(*calib::height_mm(rig.height_model, counts), height, kTolerance);
        EXPECT_GE(counts, rig.calibrated_min_counts);
        EXPECT_LE(counts, rig.calibrated_max_counts);
        EXPECT_LE(counts, geometry.full_scale_counts);
        EXPECT_GE(counts, 0);
    }
}

TEST(RigGeometry, PlacesTheTipOnTheTablet)
{
    RigGeometry const geometry { .tablet_size_mm = { 200, 100 },
                                 .rotation_deg = 90,
                                 .travel_shear = { 0.1, 0 } };
    Vec3 const place = T_tablet_world(geometry) * Vec3(10, 100, 100);
    EXPECT_LT((place - Vec3(200, 50, 100)).norm(), kTolerance) << place.transpose();
}

TEST(RigGeometry, TellsWhatIsOutOfReach)
{
    RigGeometry const geometry;
    EXPECT_TRUE(check_reach(geometry, Path({ { -100, 0, 10 }, { 100, 50, 390 } })));
    for (auto const& far : { Vec3(0, 0, 400), Vec3(0, 0, -5), Vec3(127, 0, 10), Vec3(0, -80, 10) })
        EXPECT_FALSE(check_reach(geometry, Path({ { 0, 0, 10 }, far }))) << far.transpose();
    auto const error = check_reach(geometry, Path({ { 0, 0, 10 }, { 0, 0, 500 } })).error();
    EXPECT_EQ(error.fault, Fault::User);
    EXPECT_EQ(error.message,
              "the place (0.0, 0.0, 500.0) mm is out of the rig's reach: the tablet is "
              "254 x 159 mm and travels 400 mm up");
}

} // namespace
} // namespace tractus::sim
