#include "engine/stroke/erase_tips.h"

#include "tests/engine/stroke/strokes.h"

#include <gtest/gtest.h>
#include <limits>
#include <rapidcheck/gtest.h>

namespace tractus {
namespace {

// Returns a stroke along x with `count` tips, one every millimetre.
Stroke level(std::size_t count)
{
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({ static_cast<double>(i), 0, 0 });
    return stroke_of(points);
}

std::vector<double> x_of(Stroke const& stroke)
{
    std::vector<double> x;
    for (auto const& tip : stroke.tips)
        x.push_back(tip.position_mm.x());
    return x;
}

Result<Stroke> without(Stroke const& drawn, std::vector<TipRange> const& ranges)
{
    return erase_tips(drawn, ranges);
}

TEST(EraseTips, TakesBeginMiddleAndEnd)
{
    EXPECT_EQ(x_of(without(level(6), { { 0, 1 } }).value()), (std::vector<double> { 2, 3, 4, 5 }));
    EXPECT_EQ(x_of(without(level(6), { { 2, 3 } }).value()), (std::vector<double> { 0, 1, 4, 5 }));
    EXPECT_EQ(x_of(without(level(6), { { 5, 5 } }).value()),
              (std::vector<double> { 0, 1, 2, 3, 4 }));
    EXPECT_EQ(x_of(without(level(6), { { 0, 0 }, { 2, 3 }, { 5, 5 } }).value()),
              (std::vector<double> { 1, 4 }));
}

TEST(EraseTips, RefusesWhatLeavesNoDirection)
{
    EXPECT_FALSE(without(level(6), { { 0, 5 } }));
    EXPECT_FALSE(without(level(6), { { 1, 5 } }));
    EXPECT_FALSE(without(stroke_of({ { 1, 2, 3 }, { 0, 0, 0 }, { 1, 2, 3 } }), { { 1, 1 } }));
}

TEST(EraseTips, RefusesRangesThatDoNotFitTheStroke)
{
    EXPECT_EQ(without(level(6), { { 4, 6 } }).error().message,
              "tips 5 to 7 cannot be erased: give ranges in order that share none of the stroke's "
              "6 tips");
    auto const most = std::numeric_limits<std::size_t>::max();
    for (auto const& ranges : std::vector<std::vector<TipRange>> { {},
                                                                   { { 3, 2 } },
                                                                   { { 0, 1 }, { 1, 2 } },
                                                                   { { 4, 4 }, { 0, 0 } },
                                                                   { { 0, most } },
                                                                   { { most, most } } })
        EXPECT_FALSE(without(level(6), ranges));
}

// Whichever tips are erased, all other tips must stay unchanged and in their order.
RC_GTEST_PROP(EraseTips, KeepsAllOthers, ())
{
    auto const flags = *rc::gen::container<std::vector<bool>>(rc::gen::arbitrary<bool>());
    std::vector<TipRange> ranges;
    std::vector<double> others;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (!flags[i])
            others.push_back(static_cast<double>(i));
        else if (i > 0 && flags[i - 1])
            ranges.back().last = i;
        else
            ranges.push_back({ i, i });
    auto const drawn = level(flags.size());
    auto const rest = without(drawn, ranges);
    RC_ASSERT(rest.has_value() == (!ranges.empty() && others.size() >= 2));
    if (!rest)
        return;
    RC_ASSERT(x_of(*rest) == others);
    for (auto const& tip : rest->tips)
        RC_ASSERT(tip.time == drawn.tips[static_cast<std::size_t>(tip.position_mm.x())].time);
}

} // namespace
} // namespace tractus
