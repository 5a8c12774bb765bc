#include "engine/stroke/smooth.h"

#include "engine/stroke/resample.h"
#include "tests/corpus.h"
#include "tests/engine/stroke/corpus_strokes.h"
#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

// Returns the root mean square distance between points and the points of the curve at about the
// same parameters.
double distance_mm(std::vector<Vec3> const& points, std::vector<Vec3> const& curve)
{
    double sum = 0;
    for (auto const& point : points) {
        double nearest = 1e9;
        for (auto const& other : curve)
            nearest = std::min(nearest, (point - other).squaredNorm());
        sum += nearest;
    }
    return std::sqrt(sum / static_cast<double>(points.size()));
}

double length_of(std::vector<Vec3> const& points)
{
    return ArcLength(points).length_mm();
}

TEST(SmoothHand, KeepsEverythingByDefaultOfOne)
{
    auto const drawn = trembling(s_curve(100), 2);
    EXPECT_EQ(smooth_hand_line(drawn, 1), drawn);
}

TEST(SmoothHand, TakesTheTremorOut)
{
    auto const meant = s_curve(2000);
    double drawn_mm = 0;
    double smooth_mm = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        auto const drawn = trembling(s_curve(100), 2, seed);
        auto const smooth = smooth_hand_line(drawn, 0);
        drawn_mm += distance_mm(drawn, meant);
        smooth_mm += distance_mm(smooth, meant);
        EXPECT_LT(length_of(smooth), 1.1 * length_of(meant)) << seed;
        EXPECT_GT(length_of(drawn), 1.3 * length_of(meant)) << seed;
    }
    EXPECT_LT(smooth_mm, 0.8 * drawn_mm);
}

TEST(SmoothHand, LeavesASteadyHandAlone)
{
    EXPECT_LT(distance_mm(smooth_hand_line(s_curve(400), 0), s_curve(20000)), 0.1);
}

TEST(SmoothHand, HalfKeptLiesHalfWay)
{
    auto const drawn = trembling(s_curve(100), 2);
    auto const none = smooth_hand_line(drawn, 0);
    auto const half = smooth_hand_line(drawn, 0.5);
    auto const all = resample(drawn, none.size());
    for (std::size_t i = 0; i < none.size(); ++i)
        EXPECT_LT((half[i] - (none[i] + all[i]) / 2).norm(), 1e-12);
}

TEST(SmoothHand, KeepsTheEnds)
{
    auto const drawn = trembling(s_curve(100), 2);
    for (double const kept : { 0.0, 0.7 }) {
        auto const smooth = smooth_hand_line(drawn, kept);
        EXPECT_EQ(smooth.front(), drawn.front());
        EXPECT_EQ(smooth.back(), drawn.back());
        EXPECT_GE(smooth.size(), drawn.size());
    }
}

TEST(SmoothHand, TwoPointsStayALine)
{
    std::vector<Vec3> const line { { 0, 0, 0 }, { 0, 0, 9 } };
    EXPECT_NEAR(length_of(smooth_hand_line(line, 0)), 9, 1e-12);
}

TEST(SmoothHand, ShortensWhatPeopleDrewButALittle)
{
    auto const strokes = read_strokes(shipped("strokes") / "Wire.strokes.txt");
    ASSERT_EQ(strokes.size(), 67u);
    for (auto const& stroke : strokes) {
        auto const smooth = smooth_hand_line(stroke, 0);
        EXPECT_LE(length_of(smooth), 1.02 * length_of(stroke));
        EXPECT_GE(length_of(smooth), 0.7 * length_of(stroke));
    }
}

} // namespace
} // namespace tractus
