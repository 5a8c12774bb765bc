#include "engine/base/check.h"
#include "engine/base/result.h"

#include <gtest/gtest.h>
#include <memory>

namespace tractus {
namespace {

Result<int> half(int value)
{
    if (value % 2 != 0)
        return fail(Fault::User, "odd");
    return value / 2;
}

Result<int> quarter(int value)
{
    auto const first = TRY(half(value));
    return TRY(half(first));
}

TEST(Result, TryGivesTheValue)
{
    EXPECT_EQ(quarter(12).value(), 3);
}

TEST(Result, TryReturnsTheError)
{
    auto const result = quarter(6);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().fault, Fault::User);
    EXPECT_EQ(result.error().message, "odd");
}

TEST(Result, TryMovesWhatCannotBeCopied)
{
    auto const make = []() -> Result<std::unique_ptr<int>> { return std::make_unique<int>(5); };
    auto const pass = [&]() -> Result<int> {
        auto const owned = TRY(make());
        return *owned;
    };
    EXPECT_EQ(pass().value(), 5);
}

TEST(CheckDeathTest, PrintsTheConditionAndItsPlace)
{
    EXPECT_DEATH(CHECK(1 + 1 == 3), "CHECK\\(1 \\+ 1 == 3\\) failed at .*result_test.cpp");
}

} // namespace
} // namespace tractus
