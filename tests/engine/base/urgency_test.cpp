#include "engine/base/urgency.h"

#include "engine/base/parallel.h"

#include <atomic>
#include <gtest/gtest.h>
#include <map>
#include <mutex>
#include <sched.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace tractus {
namespace {

int priority_here()
{
    return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()));
}

TEST(Urgency, WhatMayComeLaterIsBelowTheOthersWithItsHelpers)
{
    int const usual = priority_here();
    std::mutex mutex;
    std::map<pid_t, int> priorities; // Priority of each thread that took part in the loops.
    std::thread([&] {
        set_urgency(Urgency::Later);
        // Worker threads join a loop only after they wake up. So the loop is repeated up to a
        // hundred times, and its two pieces wait for each other.
        for (int i = 0; i < 100 && (i < 1 || priorities.size() < 2); ++i) {
            std::atomic<int> begun = 0;
            parallel_for(2, 1, [&](std::size_t begin, std::size_t end) {
                begun += static_cast<int>(end - begin);
                for (int turn = 0; turn < 100'000 && begun < 2; ++turn)
                    std::this_thread::yield();
                std::lock_guard const lock(mutex);
                priorities[::gettid()] = priority_here();
            });
        }
    }).join();
    ASSERT_FALSE(priorities.empty());
    for (auto const& [thread, priority] : priorities)
        EXPECT_GT(priority, usual) << thread;
    EXPECT_EQ(priority_here(), usual);
}

TEST(Urgency, WhatIsSeenSoonDoesNotInterruptWhoWakesIt)
{
    int const usual = priority_here();
    std::thread([&] {
        set_urgency(Urgency::Soon);
        EXPECT_EQ(::sched_getscheduler(0), SCHED_BATCH);
        EXPECT_EQ(priority_here(), usual);
    }).join();
    EXPECT_EQ(::sched_getscheduler(0), SCHED_OTHER);
}

// The worker threads help with the loops of all threads. After a worker has helped with
// low-priority work, it must not lower the priority of the next loop, or of the thread that waits
// for that loop.
TEST(Urgency, LoopsOfOthersStayWhereTheyAre)
{
    int const usual = priority_here();
    std::thread([] {
        set_urgency(Urgency::Later);
        parallel_for(100, 1, [](std::size_t, std::size_t) {});
    }).join();
    std::atomic<int> less_urgent = 0;
    parallel_for(100, 1, [&](std::size_t, std::size_t) {
        parallel_for(10, 1, [&](std::size_t, std::size_t) {
            less_urgent += present_urgency() != Urgency::Now;
        });
    });
    EXPECT_EQ(less_urgent, 0);
    EXPECT_EQ(priority_here(), usual);
}

} // namespace
} // namespace tractus
