#include "engine/stroke/frames.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

std::vector<Vec3> helix(int points)
{
    std::vector<Vec3> helix;
    for (int i = 0; i < points; ++i)
        helix.push_back({ std::cos(0.2 * i), std::sin(0.2 * i), 0.05 * i });
    return helix;
}

TEST(Frames, AreOrthonormalAlongAHelix)
{
    auto const points = helix(2000);
    auto const frames = rotation_minimising_frames(points);
    ASSERT_EQ(frames.size(), points.size() - 1);
    for (auto const& frame : frames) {
        EXPECT_NEAR(frame.tangent.norm(), 1, 1e-14);
        EXPECT_NEAR(frame.normal.norm(), 1, 1e-14);
        EXPECT_NEAR(frame.tangent.dot(frame.normal), 0, 1e-14);
    }
}

TEST(Frames, DoNotTurnAboutTheTangent)
{
    auto const frames = rotation_minimising_frames(helix(200));
    for (std::size_t i = 1; i < frames.size(); ++i) {
        // Parallel transport: up to second order, the change of the normal must have no component
        // along the binormal.
        Vec3 const middle = (frames[i].binormal() + frames[i - 1].binormal()) / 2;
        EXPECT_NEAR((frames[i].normal - frames[i - 1].normal).dot(middle), 0, 1e-12);
    }
}

TEST(Frames, StayTheSameAlongAPlaneCurvesNormal)
{
    std::vector<Vec3> arc;
    for (int i = 0; i <= 50; ++i)
        arc.push_back({ 0, std::cos(0.1 * i), std::sin(0.1 * i) });
    for (auto const& frame : rotation_minimising_frames(arc, Vec3::UnitX()))
        EXPECT_LT((frame.normal - Vec3::UnitX()).norm(), 1e-13);
}

TEST(Frames, SurviveATurnBack)
{
    std::vector<Vec3> const points { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, 1 } };
    for (auto const& frame : rotation_minimising_frames(points)) {
        EXPECT_NEAR(std::abs(frame.tangent.z()), 1, 1e-15);
        EXPECT_NEAR(frame.normal.x(), 1, 1e-15);
    }
}

TEST(Frames, RepeatedPointsTakeTheDirectionBefore)
{
    std::vector<Vec3> const points {
        { 0, 0, 0 }, { 0, 0, 0 }, { 2, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }
    };
    auto const frames = rotation_minimising_frames(points);
    EXPECT_EQ(frames[0].tangent, Vec3::UnitX());
    EXPECT_EQ(frames[2].tangent, Vec3::UnitX());
    EXPECT_EQ(frames[3].tangent, Vec3::UnitY());
}

TEST(Frames, LeastRotationTakesOneDirectionToTheOther)
{
    Vec3 const from = Vec3(1, 2, -0.5).normalized();
    for (Vec3 const& to :
         { Vec3(0.3, -1, 4), Vec3(1, 2, -0.5), Vec3(-1, -2, 0.5), Vec3(-1, -2, 0.500000001) })
        EXPECT_LT((least_rotation(from, to.normalized()) * from - to.normalized()).norm(), 1e-7)
            << to;
}

TEST(Frames, AHalfTurnKeepsLeftAndRight)
{
    auto const turn = least_rotation(-Vec3::UnitZ(), Vec3::UnitZ());
    EXPECT_LT((turn * Vec3(1, 0, 0) - Vec3(1, 0, 0)).norm(), 1e-15);
}

} // namespace
} // namespace tractus
