#include "calib/height_model.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace tractus::calib {
namespace {

LinearHeight const kLinear { .mm_per_count = 0.1, .zero_counts = 200 };

// At 5,000 counts the string is the 500 mm hypotenuse of a triangle with legs of 300 and 400 mm.
StringHeight const kString {
    .mm_per_count = 0.1, .zero_length_mm = 0, .offset_mm = 300, .base_mm = 50
};

TEST(HeightModel, LinearScalesFromItsZero)
{
    EXPECT_DOUBLE_EQ(*height_mm(kLinear, 200), 0);
    EXPECT_DOUBLE_EQ(*height_mm(kLinear, 1200), 100);
    EXPECT_DOUBLE_EQ(*height_mm(kLinear, 100), -10);
}

TEST(HeightModel, StringFollowsPythagoras)
{
    EXPECT_DOUBLE_EQ(*height_mm(kString, 5000), 350);
    EXPECT_DOUBLE_EQ(*height_mm(kString, 3000), -50);
}

TEST(HeightModel, StringHasNoHeightShorterThanItsOffset)
{
    EXPECT_FALSE(height_mm(kString, 2999));
    EXPECT_FALSE(counts_at_height(kString, -51));
}

TEST(HeightModel, NoHeightForWhatIsNotANumber)
{
    auto const nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(height_mm(kLinear, nan));
    EXPECT_FALSE(height_mm(kString, nan));
    EXPECT_FALSE(counts_at_height(kString, nan));
}

TEST(HeightModel, StringRisesWithEachCount)
{
    auto before = *height_mm(kString, 3000);
    for (int counts = 3001; counts <= 4095; ++counts) {
        auto const height = *height_mm(kString, counts);
        ASSERT_GT(height, before) << counts;
        before = height;
    }
}

TEST(HeightModel, CountsAreTheInverseOfHeight)
{
    for (auto const& model : { HeightModel(kLinear), HeightModel(kString) })
        for (double height = -40; height <= 400; height += 7.3)
            EXPECT_NEAR(*height_mm(model, *counts_at_height(model, height)), height, 1e-9);
}

TEST(HeightModel, StringWithoutOffsetIsLinear)
{
    StringHeight const plumb { .mm_per_count = 0.1, .zero_length_mm = 30, .base_mm = 50 };
    EXPECT_DOUBLE_EQ(*height_mm(plumb, 1200), *height_mm(kLinear, 1200));
}

// A curve that rises steeply, hardly, and steeply again.
MonotoneHeight const kCurve { .knots = { { 100, 0 }, { 600, 90 }, { 1500, 110 }, { 2000, 200 } } };

MonotoneHeight mirrored(MonotoneHeight curve)
{
    for (auto& knot : curve.knots)
        knot.height_mm = -knot.height_mm;
    return curve;
}

TEST(HeightModel, CurveGoesThroughItsKnots)
{
    for (auto const& knot : kCurve.knots) {
        EXPECT_NEAR(*height_mm(kCurve, knot.counts), knot.height_mm, 1e-9);
        EXPECT_NEAR(*height_mm(mirrored(kCurve), knot.counts), -knot.height_mm, 1e-9);
    }
}

TEST(HeightModel, CurveRisesAllTheWayAndBeyond)
{
    for (double counts = -200; counts < 2400; counts += 7) {
        EXPECT_LT(*height_mm(kCurve, counts), *height_mm(kCurve, counts + 7)) << counts;
        EXPECT_GT(*mm_per_count_at(kCurve, counts), 0) << counts;
        EXPECT_LT(*mm_per_count_at(mirrored(kCurve), counts), 0) << counts;
    }
}

TEST(HeightModel, CurvesCountsAreTheInverseOfItsHeight)
{
    for (double height = -30; height <= 230; height += 3.7) {
        EXPECT_NEAR(*height_mm(kCurve, *counts_at_height(kCurve, height)), height, 1e-9);
        auto const down = mirrored(kCurve);
        EXPECT_NEAR(*height_mm(down, *counts_at_height(down, -height)), -height, 1e-9);
    }
}

TEST(HeightModel, CurveThroughAStraightLineIsThatLine)
{
    MonotoneHeight const straight { .knots = { { 0, 0 }, { 300, 30 }, { 1000, 100 } } };
    for (double counts = -100; counts < 1100; counts += 50)
        EXPECT_NEAR(*height_mm(straight, counts), counts / 10, 1e-9);
}

TEST(HeightModel, SpoolAboveIsUpsideDown)
{
    StringHeight const above {
        .mm_per_count = 0.1, .offset_mm = 300, .base_mm = -450, .spool = StringHeight::Spool::Above
    };
    EXPECT_DOUBLE_EQ(*height_mm(above, 5000), 50);
    EXPECT_DOUBLE_EQ(*height_mm(above, 3000), 450);
    EXPECT_DOUBLE_EQ(*counts_at_height(above, 50), 5000);
}

TEST(HeightModel, RaisingKeepsTheScale)
{
    StringHeight down = kString;
    down.mm_per_count = -0.1;
    down.zero_length_mm = 600;
    for (auto const& [model, counts] :
         { std::pair(HeightModel(kLinear), 700.0), std::pair(HeightModel(kString), 4100.0),
           std::pair(HeightModel(down), 1500.0), std::pair(HeightModel(kCurve), 900.0) }) {
        auto const higher = raised(model, 12.5);
        EXPECT_NEAR(*height_mm(higher, counts), *height_mm(model, counts) + 12.5, 1e-9);
        EXPECT_NEAR(*mm_per_count_at(higher, counts), *mm_per_count_at(model, counts), 1e-9);
    }
}

TEST(HeightModel, KnowsWhichNumbersMakeSense)
{
    EXPECT_TRUE(is_valid(kLinear));
    EXPECT_TRUE(is_valid(kString));
    EXPECT_TRUE(is_valid(kCurve));
    EXPECT_FALSE(is_valid(LinearHeight { .mm_per_count = 0 }));
    EXPECT_FALSE(is_valid(StringHeight { .offset_mm = -1 }));
    EXPECT_FALSE(is_valid(MonotoneHeight {}));
    EXPECT_FALSE(is_valid(MonotoneHeight { .knots = { { 0, 0 }, { 1, 1 }, { 2, 1 } } }));
    EXPECT_FALSE(is_valid(MonotoneHeight { .knots = { { 0, 0 }, { 1, 1 }, { 1, 2 } } }));
}

TEST(HeightModel, ReadsABentTrackAsAStraightOneAndBack)
{
    // A voltage divider, loaded by the converter's input at its lower half: p / (1 + a p (1 - p)).
    constexpr double kFull = 4096;
    constexpr double kLoad = 0.015;
    TrackBend bend;
    auto const loaded = [](double part) { return part / (1 + kLoad * part * (1 - part)); };
    for (int i = 0; i <= 10; ++i)
        bend.push_back({ kFull * loaded(i / 10.0), kFull * (i / 10.0 - loaded(i / 10.0)) });
    StringHeight const aslant { .mm_per_count = 0.1, .zero_length_mm = 50, .offset_mm = 100 };
    for (auto const& straight : { HeightModel(kLinear), HeightModel(aslant) }) {
        auto const model = with_bend(straight, bend);
        ASSERT_TRUE(is_valid(model));
        for (double part = 0.3; part < 0.95; part += 0.05) {
            auto const height = height_mm(model, kFull * loaded(part));
            ASSERT_TRUE(height);
            EXPECT_NEAR(*height, *height_mm(straight, kFull * part), 0.01) << part;
            EXPECT_NEAR(*counts_at_height(model, *height), kFull * loaded(part), 1e-6) << part;
        }
        EXPECT_GT(
            std::abs(*height_mm(straight, kFull * loaded(0.6)) - *height_mm(straight, kFull * 0.6)),
            0.5);
    }
}

TEST(HeightModel, RefusesABendThatTurnsReadingsRound)
{
    EXPECT_TRUE(is_valid(LinearHeight { .bend = { { 0, 0 }, { 100, 20 }, { 200, -5 } } }));
    EXPECT_FALSE(is_valid(LinearHeight { .bend = { { 0, 0 }, { 100, -120 } } }));
    EXPECT_FALSE(is_valid(LinearHeight { .bend = { { 100, 0 }, { 0, 0 } } }));
    EXPECT_FALSE(is_valid(StringHeight { .bend = { { 0, 0 }, { 0, 0 } } }));
}

TEST(HeightModel, TakesItsParametersBack)
{
    for (auto const& model : { HeightModel(kLinear), HeightModel(kString), HeightModel(kCurve) }) {
        Eigen::VectorXd const doubled = 2 * parameters_of(model);
        EXPECT_EQ(parameters_of(with_parameters(model, doubled)), doubled);
    }
}

} // namespace
} // namespace tractus::calib
