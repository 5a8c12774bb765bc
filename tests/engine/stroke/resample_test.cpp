#include "engine/stroke/resample.h"

#include "engine/stroke/polyline.h"
#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus {
namespace {

TEST(Resample, PutsPointsAtEqualDistances)
{
    std::vector<Vec3> const corner { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 } };
    auto const points = resample(corner, 5);
    ASSERT_EQ(points.size(), 5u);
    EXPECT_EQ(points[0], corner[0]);
    EXPECT_LT((points[2] - Vec3(2, 0, 0)).norm(), 1e-15);
    EXPECT_LT((points[3] - Vec3(3, 0, 0)).norm(), 1e-15);
    EXPECT_EQ(points[4], corner[2]);
}

TEST(Resample, RepeatedPointsChangeNothing)
{
    std::vector<Vec3> const once { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 1, 0 } };
    std::vector<Vec3> const often { { 0, 0, 0 }, { 0, 0, 0 }, { 3, 0, 0 }, { 3, 0, 0 },
                                    { 3, 0, 0 }, { 3, 1, 0 }, { 3, 1, 0 } };
    EXPECT_EQ(resample(often, 9), resample(once, 9));
}

TEST(Resample, OnePlaceStaysOnePlace)
{
    std::vector<Vec3> const place(4, Vec3(1, 2, 3));
    for (auto const& point : resample(place, 3))
        EXPECT_EQ(point, Vec3(1, 2, 3));
}

TEST(StrokePoints, LeavesOutWhatRepeats)
{
    auto const points
        = stroke_points(stroke_of({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }));
    ASSERT_TRUE(points);
    EXPECT_EQ(points->size(), 3u);
}

TEST(StrokePoints, RefusesWhatHasNoDirection)
{
    for (auto const& stroke : { Stroke {}, stroke_of({ { 1, 2, 3 } }),
                                stroke_of({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }) }) {
        auto const points = stroke_points(stroke);
        ASSERT_FALSE(points);
        EXPECT_EQ(points.error().fault, Fault::User);
        EXPECT_NE(points.error().message.find("in one place: draw a longer stroke"),
                  std::string::npos);
    }
}

TEST(StrokePoints, RefusesWhatIsNotANumber)
{
    double const nan = std::numeric_limits<double>::quiet_NaN();
    auto const points = stroke_points(stroke_of({ { 0, 0, 0 }, { 0, nan, 0 }, { 1, 0, 0 } }));
    ASSERT_FALSE(points);
    EXPECT_EQ(points.error().message, "point 2 of the stroke's 3 is not a number: draw it again");
}

} // namespace
} // namespace tractus
