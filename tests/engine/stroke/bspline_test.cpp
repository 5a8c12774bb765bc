#include "engine/stroke/bspline.h"

#include "engine/stroke/subdivision.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

std::vector<Vec3> const kControl {
    { 0, 0, 0 }, { 1, 2, 0 }, { 3, 3, 1 }, { 4, 0, 2 }, { 6, 1, 5 }
};

TEST(BSpline, ClampedCurveBeginsAndEndsInItsControlPoints)
{
    for (int const degree : { 2, 3 }) {
        EXPECT_EQ(bspline_point(kControl, 0, { .degree = degree }), kControl.front());
        EXPECT_EQ(bspline_point(kControl, 1, { .degree = degree }), kControl.back());
    }
}

TEST(BSpline, FourClampedPointsAreABezierCurve)
{
    auto const four = std::span(kControl).first(4);
    double const t = 0.3;
    double const s = 1 - t;
    Vec3 const bezier = s * s * s * four[0] + 3 * s * s * t * four[1] + 3 * s * t * t * four[2]
        + t * t * t * four[3];
    EXPECT_LT((bspline_point(four, t) - bezier).norm(), 1e-15);
}

TEST(BSpline, UniformCubicStartsAtTheAverageOfItsFirstThree)
{
    auto const start = bspline_point(kControl, 0, { .ends = BSplineOptions::Ends::Uniform });
    EXPECT_LT((start - (kControl[0] + 4 * kControl[1] + kControl[2]) / 6).norm(), 1e-15);
}

TEST(BSpline, QuadraticIsTheLimitOfSubdivision)
{
    std::vector<Vec3> refined = kControl;
    for (int round = 0; round < 10; ++round)
        refined = subdivide(refined);
    auto const curve = bspline_points(kControl, 8000, { .degree = 2 });
    for (std::size_t i = 0; i < refined.size(); i += 37) {
        double nearest = 1;
        for (auto const& point : curve)
            nearest = std::min(nearest, (point - refined[i]).norm());
        EXPECT_LT(nearest, 2e-3) << i;
    }
}

TEST(BSpline, TooFewPointsLowerTheDegree)
{
    EXPECT_EQ(bspline_point(std::span(kControl).first(1), 0.5), kControl[0]);
    EXPECT_EQ(bspline_point(std::span(kControl).first(2), 0.5), Vec3(0.5, 1, 0));
}

} // namespace
} // namespace tractus
