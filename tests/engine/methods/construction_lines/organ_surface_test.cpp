#include "engine/methods/construction_lines/organ_surface.h"

#include "engine/methods/construction_lines/organ_text.h"

#include "engine/lsystem/view/surface_file.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::lines {
namespace {

OrganViews lens()
{
    OrganViews views;
    constexpr int kPoints = 200;
    for (int i = 0; i <= kPoints; ++i) {
        double const t = static_cast<double>(i) / kPoints;
        views.left.emplace_back(-40 * t * (1 - t), 100 * t);
        views.right.emplace_back(60 * t * (1 - t), 100 * t);
    }
    return views;
}

std::vector<BezierPatch> surface_of(OrganViews const& views)
{
    auto const patches = organ_surface(views);
    EXPECT_TRUE(patches) << patches.error().message;
    return *patches;
}

// Returns the point of the surface at (u, v), both from 0 to 1.
Vec3 at(std::vector<BezierPatch> const& patches, double u, double v)
{
    auto const row = std::min(static_cast<int>(u * kAlong), kAlong - 1);
    auto const column = std::min(static_cast<int>(v * kAcross), kAcross - 1);
    return patches[static_cast<std::size_t>(row * kAcross + column)].at(u * kAlong - row,
                                                                        v * kAcross - column);
}

TEST(OrganSurface, HasItsSidesOnTheBoundaries)
{
    auto views = lens();
    views.midrib = { { 0, 0 }, { 30, 12 }, { 100, 5 } };
    views.section = { { -1, 1 }, { 0, 0 }, { 1, 1 } };
    auto const patches = surface_of(views);
    for (int i = 0; i <= 40; ++i) {
        auto const left = at(patches, i / 40.0, 0);
        auto const right = at(patches, i / 40.0, 1);
        double const t = left.y() / 100;
        double const s = right.y() / 100;
        EXPECT_NEAR(left.x(), -40 * t * (1 - t), 0.1);
        EXPECT_NEAR(right.x(), 60 * s * (1 - s), 0.1);
        EXPECT_NEAR(left.z(), right.z(), 1e-9);
    }
}

TEST(OrganSurface, IsFlatOfAStraightMidribAndSection)
{
    auto views = lens();
    views.midrib = { { 0, 3 }, { 80, 40 } };
    views.section = { { -5, 2 }, { 5, 4 } };
    for (auto const& patch : surface_of(views))
        for (auto const& point : patch.control)
            EXPECT_NEAR(point.z(), 0, 1e-9);
}

TEST(OrganSurface, BlendsSectionAndMidribAsTheFormulaSays)
{
    // A strip 20 wide and 100 long that is folded by 45 degrees. Its midrib has a corner.
    OrganViews const views { .left = { { -10, 0 }, { -10, 100 } },
                             .right = { { 10, 0 }, { 10, 100 } },
                             .midrib = { { 0, 0 }, { 50, 30 }, { 100, 0 } },
                             .section = { { -1, 1 }, { 0, 0 }, { 1, 1 } } };
    auto const patches = surface_of(views);
    for (int i = 0; i <= kAlong; ++i)
        for (int k = 0; k <= kAcross; ++k) {
            double const u = static_cast<double>(i) / kAlong;
            double const v = static_cast<double>(k) / kAcross;
            Vec3 const expected(-10 + 20 * v, 100 * u,
                                30 * (1 - std::fabs(2 * u - 1)) - 10 * (1 - std::fabs(2 * v - 1)));
            EXPECT_LT((at(patches, u, v) - expected).norm(), 1e-9) << u << ' ' << v;
        }
}

TEST(OrganSurface, IsTheSameInItsFile)
{
    auto views = lens();
    views.midrib = { { 0, 0 }, { 30, 12 }, { 100, 5 } };
    auto const patches = surface_of(views);
    auto const read = lsystem::parse_surface("organ.s", format_surface(patches), 100);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->patches.size(), patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        EXPECT_EQ(read->patches[i].neighbors, patches[i].neighbors);
        for (std::size_t k = 0; k < 16; ++k)
            EXPECT_LT((read->patches[i].control[k] - patches[i].control[k]).norm(), 1e-3);
    }
}

TEST(OrganSurface, RefusesViewsThatGiveNone)
{
    auto views = lens();
    views.midrib = { { 0, 0 }, { 30, 12 }, { 20, 5 } };
    EXPECT_NE(organ_surface(views).error().message.find("midrib turns back at point 3"),
              std::string::npos);
    EXPECT_FALSE(organ_surface({}));
    views.midrib = { { 0, 0 } };
    EXPECT_FALSE(organ_surface(views));
    EXPECT_FALSE(
        organ_surface({ .left = { { 1, 1 }, { 1, 1 } }, .right = { { 1, 1 }, { 2, 2 } } }));
}

} // namespace
} // namespace tractus::lines
