#include "app/newest_job.h"

#include <gtest/gtest.h>
#include <memory>

namespace tractus {
namespace {

using Doubling = NewestJob<int, int>;

TEST(NewestJob, MakesWhatIsWanted)
{
    Doubling job([](int wanted) { return 2 * wanted; });
    EXPECT_FALSE(job.is_busy());
    EXPECT_FALSE(job.take());
    job.want(21);
    EXPECT_TRUE(job.is_busy());
    job.settle();
    EXPECT_TRUE(job.is_busy()) << "it was not taken";
    EXPECT_EQ(job.take(), 42);
    EXPECT_FALSE(job.is_busy());
    EXPECT_FALSE(job.take());
}

TEST(NewestJob, GivesTheNewestOfManyWishesInTheEnd)
{
    Doubling job([](int wanted) { return 2 * wanted; });
    int last = 0;
    for (int i = 1; i <= 20'000; ++i) {
        job.want(i);
        if (auto const made = job.take()) {
            EXPECT_GT(*made, last) << "never an older one";
            last = *made;
        }
    }
    job.settle();
    EXPECT_EQ(job.take().value_or(last), 40'000);
}

TEST(NewestJob, FinishesWhatItMakesBeforeItGoes)
{
    auto const shared = std::make_shared<int>(7);
    for (int i = 0; i < 200; ++i) {
        NewestJob<std::shared_ptr<int>, std::shared_ptr<int>> job(
            [](std::shared_ptr<int> const& wanted) { return wanted; });
        job.want(shared);
    }
    EXPECT_EQ(shared.use_count(), 1);
}

} // namespace
} // namespace tractus
