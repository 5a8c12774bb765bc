#include "engine/methods/sketch_lsystem/stroke_resampler.h"

#include "tests/engine/methods/sketch_lsystem/strokes.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus::sketch {
namespace {

Rule rule_of(double first_length_mm, double length_ratio)
{
    return { .first_length_mm = first_length_mm, .length_ratio = length_ratio };
}

int segments_of(std::vector<Vec3> const& tips, Rule const& rule)
{
    return static_cast<int>(resample_stroke(rule, tips).size()) - 1;
}

TEST(StrokeResampler, DividesStraightStrokesAsTheGeometricSeriesSays)
{
    EXPECT_EQ(segments_of(straight_stroke(100), rule_of(40, 0.8)), 3);
    // The stroke is exactly as long as two segments, 40 + 32.
    EXPECT_EQ(segments_of(straight_stroke(72), rule_of(40, 0.8)), 2);
    EXPECT_EQ(segments_of(straight_stroke(150), rule_of(30, 0.9)), 6);
    EXPECT_EQ(segments_of(straight_stroke(100), rule_of(25, 1)), 4);
    EXPECT_EQ(segments_of(straight_stroke(99.9), rule_of(25, 1)), 3);
    EXPECT_EQ(segments_of(straight_stroke(200), rule_of(20, 1.2)), 6);
    EXPECT_EQ(segments_of(straight_stroke(39), rule_of(40, 0.8)), 0);
}

TEST(StrokeResampler, EndsWhereTheNextSegmentWouldBeTooShort)
{
    EXPECT_EQ(segments_of(straight_stroke(1000), rule_of(40, 0.8)), 17);
    StrokeResampler resampler(rule_of(40, 0.8));
    for (auto const& tip : straight_stroke(1000))
        resampler.push(tip);
    EXPECT_TRUE(resampler.is_full());
    EXPECT_LT(resampler.next_length_mm(), 1);
}

TEST(StrokeResampler, MakesNoMoreSegmentsThanTheRuleAllows)
{
    auto rule = rule_of(5, 1);
    rule.most_segments = 7;
    EXPECT_EQ(segments_of(straight_stroke(1000, 2), rule), 7);
}

// The expected number is floor(pi / (2 asin(l / 2R))): the chords count, not the length along the
// arc.
TEST(StrokeResampler, CountsChordsOnAHalfCircle)
{
    EXPECT_EQ(segments_of(half_circle(50), rule_of(30, 1)), 5);
    EXPECT_EQ(segments_of(half_circle(20), rule_of(30, 1)), 1);
    EXPECT_EQ(segments_of(half_circle(100), rule_of(30, 1)), 10);
}

TEST(StrokeResampler, MakesTheSameNodesHoweverDenselyAStrokeIsSampled)
{
    auto const sparse = resample_stroke(rule_of(30, 0.9), straight_stroke(150, 3));
    auto const dense = resample_stroke(rule_of(30, 0.9), straight_stroke(150, 5000));
    ASSERT_EQ(sparse.size(), dense.size());
    for (std::size_t i = 0; i < dense.size(); ++i)
        EXPECT_LT((sparse[i] - dense[i]).norm(), 1e-9);
}

TEST(StrokeResampler, LosesNoSegmentWhenThePenGoesBack)
{
    StrokeResampler resampler(rule_of(30, 1));
    EXPECT_EQ(resampler.push(Vec3::Zero()), 0);
    EXPECT_EQ(resampler.push({ 0, 0, 65 }), 2);
    EXPECT_EQ(resampler.push({ 0, 0, 50 }), 0);
    EXPECT_EQ(resampler.push({ 0, 0, 65 }), 0);
    EXPECT_EQ(resampler.segments(), 2);
    EXPECT_EQ(resampler.push({ 0, 0, 90 }), 1);
}

TEST(StrokeResampler, LeavesTipsOutThatAreNotFinite)
{
    StrokeResampler resampler(rule_of(30, 1));
    double const nan = std::numeric_limits<double>::quiet_NaN();
    resampler.push({ nan, 0, 0 });
    resampler.push(Vec3::Zero());
    resampler.push({ 0, nan, 31 });
    resampler.push({ 0, 0, std::numeric_limits<double>::infinity() });
    EXPECT_EQ(resampler.push({ 0, 0, 31 }), 1);
    EXPECT_TRUE(resampler.nodes_mm()[1].isApprox(Vec3(0, 0, 30)));
}

} // namespace
} // namespace tractus::sketch
