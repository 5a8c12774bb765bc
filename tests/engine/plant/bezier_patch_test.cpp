#include "engine/plant/bezier_patch.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

// Returns control points of z = x^2 - y over a square, with s along -y and t along x.
std::array<Vec3, 16> grid(double low, double high)
{
    std::array<Vec3, 16> points;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            double const x = low + (high - low) * static_cast<double>(column) / 3;
            double const y = high - (high - low) * static_cast<double>(row) / 3;
            points[4 * row + column] = { x, y, x * x - y };
        }
    return points;
}

TEST(BezierPatch, BeginsAndEndsInItsCornerPoints)
{
    BezierPatch const patch { grid(-1, 2) };
    EXPECT_EQ(patch.at(0, 0), patch.control[0]);
    EXPECT_EQ(patch.at(0, 1), patch.control[3]);
    EXPECT_EQ(patch.at(1, 0), patch.control[12]);
    EXPECT_EQ(patch.at(1, 1), patch.control[15]);
}

TEST(BezierPatch, HasTheNormalOfItsTangents)
{
    BezierPatch const patch { grid(-1, 2) };
    for (double const s : { 0.0, 0.3, 1.0 })
        for (double const t : { 0.0, 0.6, 1.0 }) {
            constexpr double kStep = 1e-5;
            Vec3 const along_s = patch.at(s + kStep, t) - patch.at(s - kStep, t);
            Vec3 const along_t = patch.at(s, t + kStep) - patch.at(s, t - kStep);
            Vec3 const expected = along_s.cross(along_t).normalized();
            EXPECT_LT((patch.normal_at(s, t).normalized() - expected).norm(), 1e-6);
        }
    EXPECT_GT(patch.normal_at(0.5, 0.5).z(), 0);
}

// Each of the three bases reproduces quadratic functions up to a constant. The constant tells the
// bases apart on a known surface.
TEST(BezierPatch, TakesOtherBases)
{
    auto const points = grid(-3, 3); // The inner control points are at -1 and 1.
    BezierPatch const cardinal { bezier_control(points, PatchBasis::Cardinal) };
    EXPECT_LT((cardinal.at(0, 0) - points[5]).norm(), 1e-12);
    EXPECT_LT((cardinal.at(1, 1) - points[10]).norm(), 1e-12);
    Vec3 const middle = cardinal.at(0.5, 0.75);
    EXPECT_LT((middle - Vec3(0.5, 0, 0.25)).norm(), 1e-12);
    BezierPatch const spline { bezier_control(points, PatchBasis::BSpline) };
    // A uniform cubic B-spline with the control points of y = x^2, in steps of 2, is 4 / 3 above
    // this curve.
    EXPECT_LT((spline.at(0.5, 0.75) - Vec3(0.5, 0, 0.25 + 4.0 / 3)).norm(), 1e-12);
    EXPECT_EQ(bezier_control(points, PatchBasis::Bezier), points);
}

} // namespace
} // namespace tractus
