#include "engine/base/newest_job.h"

#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

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

// Work that reports that it has begun. If 0 is wanted, it works until it is told to stop.
struct Endless {
    std::atomic<bool>* has_begun;

    int operator()(int wanted, std::stop_token const& stop) const
    {
        *has_begun = true;
        while (wanted == 0 && !stop.stop_requested())
            std::this_thread::yield();
        return wanted;
    }
};

// A job that has begun work on 0, which does not end by itself.
struct EndlessJob {
    EndlessJob()
    {
        job.want(0);
        while (!has_begun)
            std::this_thread::yield();
    }

    std::atomic<bool> has_begun = false;
    NewestJob<int, int> job { Endless { &has_begun } };
};

TEST(NewestJob, StopsWhatItMakesWhenItGoes)
{
    EndlessJob const goes_at_once;
}

TEST(NewestJob, StopsLongWorkThatNobodyWantsAnyMore)
{
    EndlessJob endless;
    std::optional<int> made;
    for (int wish = 1; !made; ++wish) { // The first wishes may be superseded before they are done.
        endless.job.want(wish);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        made = endless.job.take();
    }
    EXPECT_NE(made, 0) << "never what was stopped";
}

} // namespace
} // namespace tractus
