#include "engine/base/shared_vector.h"

#include <gtest/gtest.h>

namespace tractus {
namespace {

TEST(SharedVector, SharesItsElementsWithItsCopies)
{
    SharedVector<int> const one { 1, 2, 3 };
    auto const other = one;
    EXPECT_EQ(other.data(), one.data());
    EXPECT_EQ(other, one);
    EXPECT_EQ(other.size(), 3u);
}

TEST(SharedVector, HasItsOwnElementsOnceItIsChanged)
{
    SharedVector<int> const one { 1, 2, 3 };
    auto other = one;
    other.own()[0] = 7;
    other.push_back(4);
    EXPECT_EQ(one.vector(), (std::vector { 1, 2, 3 }));
    EXPECT_EQ(other.vector(), (std::vector { 7, 2, 3, 4 }));
    EXPECT_NE(other, one);
}

TEST(SharedVector, IsChangedInPlaceByItsOnlyOwner)
{
    SharedVector<int> one(std::vector { 1, 2, 3 });
    auto const* const data = one.data();
    one.own()[0] = 7;
    EXPECT_EQ(one.data(), data);
    EXPECT_EQ(one.front(), 7);
}

// A source of numbers that counts how often it is read.
struct Numbers : ElementSource<int> {
    Result<std::vector<int>> read() const override
    {
        ++reads;
        return std::vector { 1, 2, 3 };
    }
    mutable int reads = 0;
};

TEST(SharedVector, IsReadFromItsSourceWhenSomebodyLooksAtIt)
{
    auto const numbers = std::make_shared<Numbers>();
    SharedVector<int> const whole(std::vector { 1, 2, 3 }, numbers);
    EXPECT_TRUE(whole.is_in_memory());
    auto const parked = whole.parked();
    auto const copy = parked;
    EXPECT_FALSE(parked.is_in_memory());
    EXPECT_EQ(parked.source(), numbers);
    EXPECT_EQ(numbers->reads, 0);
    EXPECT_EQ(parked, whole);
    EXPECT_EQ(copy.size(), 3u);
    EXPECT_TRUE(copy.is_in_memory());
    EXPECT_EQ(numbers->reads, 1);
}

// A source of numbers that fails when it is read for the first time.
struct Unreadable : ElementSource<int> {
    Result<std::vector<int>> read() const override
    {
        if (reads++ == 0)
            return fail(Fault::User, "the disk is away");
        return std::vector { 1, 2, 3 };
    }
    mutable int reads = 0;
};

TEST(SharedVector, IsReadAgainAfterItCouldNotBe)
{
    auto const parked
        = SharedVector<int>(std::vector { 1, 2, 3 }, std::make_shared<Unreadable>()).parked();
    auto const failed = parked.in_memory();
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().message, "the disk is away");
    EXPECT_EQ(parked.in_memory().value().size(), 3u);

    auto const looked_at
        = SharedVector<int>(std::vector { 1, 2, 3 }, std::make_shared<Unreadable>()).parked();
    EXPECT_TRUE(looked_at.empty());
    EXPECT_EQ(looked_at.size(), 3u);
    EXPECT_TRUE(looked_at.is_in_memory());
}

TEST(SharedVector, IsInMemoryOnlyAsLongAsACopyThatIsLookedAt)
{
    auto const numbers = std::make_shared<Numbers>();
    auto const parked = SharedVector<int>(std::vector { 1, 2, 3 }, numbers).parked();
    EXPECT_EQ(parked.in_memory().value().vector(), (std::vector { 1, 2, 3 }));
    EXPECT_FALSE(parked.is_in_memory());
    auto const copy = parked.in_memory().value();
    EXPECT_EQ(copy.in_memory().value().data(), copy.data());
    EXPECT_EQ(numbers->reads, 2);
    EXPECT_EQ(copy.id(), parked.id());
    EXPECT_NE(copy.id(), SharedVector<int>({ 1, 2, 3 }).id());
}

TEST(SharedVector, IsNoMoreItsSourcesOnceItIsChanged)
{
    auto parked = SharedVector<int>({}, std::make_shared<Numbers>()).parked();
    parked.push_back(4);
    EXPECT_EQ(parked.source(), nullptr);
    EXPECT_EQ(parked.vector(), (std::vector { 1, 2, 3, 4 }));
}

TEST(SharedVector, IsEmptyAtFirstAndWhenItIsCleared)
{
    SharedVector<int> one;
    EXPECT_TRUE(one.empty());
    EXPECT_EQ(one, SharedVector<int>(std::vector<int> {}));
    one.push_back(1);
    auto const copy = one;
    one.clear();
    EXPECT_TRUE(one.empty());
    EXPECT_EQ(copy.back(), 1);
}

} // namespace
} // namespace tractus
