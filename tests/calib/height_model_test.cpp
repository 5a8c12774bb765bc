#include "calib/height_model.h"

#include <gtest/gtest.h>
#include <limits>

namespace tractus {
namespace {

constexpr LinearHeight kLinear { .mm_per_count = 0.1, .zero_counts = 200 };

// A right triangle of 300, 400 and 500 mm at 5,000 counts.
constexpr StringHeight kString {
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
    for (HeightModel const model : { HeightModel(kLinear), HeightModel(kString) })
        for (double height = -40; height <= 400; height += 7.3)
            EXPECT_NEAR(*height_mm(model, *counts_at_height(model, height)), height, 1e-9);
}

TEST(HeightModel, StringWithoutOffsetIsLinear)
{
    StringHeight const plumb { .mm_per_count = 0.1, .zero_length_mm = 30, .base_mm = 50 };
    EXPECT_DOUBLE_EQ(*height_mm(plumb, 1200), *height_mm(kLinear, 1200));
}

} // namespace
} // namespace tractus
