#include "engine/stroke/upright_sheet.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

std::vector<TipSample> tips_of(std::vector<Vec3> const& positions_mm)
{
    std::vector<TipSample> tips;
    for (auto const& position_mm : positions_mm)
        tips.push_back({ .position_mm = position_mm });
    return tips;
}

TEST(UprightSheet, IsPaperWhereTheSurfaceHardlyMoved)
{
    auto const still = tips_of({ { 0, 0, 80 }, { 0, 100, 84 } });
    auto const moved = tips_of({ { 0, 0, 80 }, { 0, 100, 86 } });
    EXPECT_EQ(resolve_surface(still, StrokeSurface::Decided), StrokeSurface::Paper);
    EXPECT_EQ(resolve_surface(moved, StrokeSurface::Decided), StrokeSurface::Space);
    EXPECT_EQ(resolve_surface(moved, StrokeSurface::Paper), StrokeSurface::Paper);
    EXPECT_EQ(resolve_surface(still, StrokeSurface::Space), StrokeSurface::Space);
}

TEST(UprightSheet, StandsWithTheUsersAwayAsUp)
{
    auto const tips = tips_of({ { 3, -20, 80 }, { 5, 30, 82 } });
    auto const plant = plant_tips(tips, StrokeSurface::Paper);
    EXPECT_EQ(plant[0], Vec3(3, 0, -20));
    // A point 2 mm higher than the first one is 2 mm in front of the sheet, towards the user.
    EXPECT_EQ(plant[1], Vec3(5, -2, 30));
    EXPECT_EQ(plant_tips(tips, StrokeSurface::Space)[1], Vec3(5, 30, 82));
}

} // namespace
} // namespace tractus
