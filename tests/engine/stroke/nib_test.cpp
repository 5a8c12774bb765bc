#include "engine/stroke/nib.h"

#include <gtest/gtest.h>
#include <optional>
#include <rapidcheck.h>
#include <vector>

namespace tractus {
namespace {

// Returns ten tips, each displaced by `way` (in mm) from the previous one. If `lean_deg` is given,
// the pen leans by this angle to +x.
std::vector<TipSample> tips_along(Vec3 const& way, std::optional<double> lean_deg)
{
    std::vector<TipSample> tips(10);
    for (std::size_t i = 0; i < tips.size(); ++i) {
        tips[i].position_mm = static_cast<double>(i) * way;
        if (lean_deg)
            tips[i].tilt_rad = Vec2(radians(*lean_deg), 0);
    }
    return tips;
}

double broad(Nib nib, Vec3 const& way, std::optional<double> lean_deg)
{
    return broadening(nib, tips_along(way, lean_deg), 5);
}

TEST(Nib, IsAsBroadAcrossTheLeanAsItsSideIsLong)
{
    EXPECT_DOUBLE_EQ(broad(Nib::Side, Vec3::UnitY(), 65), 4);
    EXPECT_DOUBLE_EQ(broad(Nib::Side, Vec3::UnitX(), 65), 1) << "along the lean";
    EXPECT_DOUBLE_EQ(broad(Nib::Side, Vec3::UnitZ(), 65), 4) << "straight up";
    EXPECT_NEAR(broad(Nib::Side, Vec3(1, 1, 0), 65), 1 + 3 * std::sqrt(0.5), 1e-12);
}

TEST(Nib, DrawsWithItsPointUntilItLeansByThirtyDegrees)
{
    EXPECT_EQ(broad(Nib::Side, Vec3::UnitY(), 29), 1);
    EXPECT_DOUBLE_EQ(broad(Nib::Side, Vec3::UnitY(), 45), 2.5) << "half way to 60";
    EXPECT_EQ(broad(Nib::Side, Vec3::UnitY(), std::nullopt), 1) << "no tilt is told";
    EXPECT_EQ(broad(Nib::Point, Vec3::UnitY(), 65), 1);
}

TEST(Nib, LeavesAllOfItsSideWhereItRests)
{
    EXPECT_DOUBLE_EQ(broad(Nib::Side, Vec3::Zero(), 65), 4);
    EXPECT_DOUBLE_EQ(broadening(Nib::Side, std::vector { tips_along(Vec3::UnitX(), 65)[0] }, 0), 4);
}

// Between two reports, a hand trembles by tenths of a millimetre. So the direction of drawing must
// be measured over longer distances.
TEST(Nib, TakesNoTremorForADirection)
{
    auto tips = tips_along(0.1 * Vec3::UnitX(), 65);
    tips.resize(60, tips.back());
    for (std::size_t i = 0; i < tips.size(); ++i)
        tips[i].position_mm = Vec3(0.1 * static_cast<double>(i), i % 2 ? 0.2 : 0, 0);
    EXPECT_LT(broadening(Nib::Side, tips, 30), 1.5);
}

TEST(Nib, IsTheSameHoweverTheWorldIsTurned)
{
    rc::check([] {
        auto const angle = [](double most) {
            return most * static_cast<double>(*rc::gen::inRange(-1000, 1001)) / 1000;
        };
        double const tilt_x = angle(1.2), tilt_y = angle(1.2), turn = angle(kPi);
        std::vector<TipSample> tips(9);
        for (auto& tip : tips) {
            tip.position_mm = Vec3(angle(9), angle(9), angle(9));
            tip.tilt_rad = Vec2(tilt_x, tilt_y);
        }
        auto turned = tips;
        Eigen::Rotation2Dd const turns(turn);
        Vec2 const slope = turns * Vec2(std::tan(tilt_x), std::tan(tilt_y));
        for (auto& tip : turned) {
            tip.position_mm.head<2>() = (turns * tip.position_mm.head<2>()).eval();
            tip.tilt_rad = Vec2(std::atan(slope.x()), std::atan(slope.y()));
        }
        double const one = broadening(Nib::Side, tips, 4);
        RC_ASSERT(one >= 1 && one <= 4);
        RC_ASSERT(std::abs(one - broadening(Nib::Side, turned, 4)) < 1e-9);
    });
}

} // namespace
} // namespace tractus
