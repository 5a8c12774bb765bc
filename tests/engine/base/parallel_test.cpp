#include "engine/base/parallel.h"

#include "engine/base/worker_threads.h"

#include <atomic>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <numeric>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <thread>
#include <vector>

namespace tractus {
namespace {

// Returns the squares of 0 to count - 1, in the order in which parallel_in_order() used them. Stops
// after `end_after` numbers.
std::vector<std::size_t> squares(std::size_t count, std::size_t slots, std::size_t end_after)
{
    std::vector<std::size_t> numbers(slots);
    std::vector<std::size_t> used;
    std::size_t begun = 0;
    parallel_in_order(slots,
                      { .next =
                            [&](std::size_t slot) {
                                if (begun == count)
                                    return false;
                                numbers[slot] = begun++;
                                return true;
                            },
                        .make = [&](std::size_t slot) { numbers[slot] *= numbers[slot]; },
                        .use =
                            [&](std::size_t slot) {
                                used.push_back(numbers[slot]);
                                return used.size() < end_after;
                            } });
    return used;
}

template<typename Work> auto on_threads(int count, Work const& work)
{
    tbb::global_control const limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(count));
    return tbb::task_arena(count).execute(work);
}

TEST(ParallelInOrder, UsesEveryPieceInOrder)
{
    std::vector<std::size_t> expected(1000);
    for (std::size_t i = 0; i < expected.size(); ++i)
        expected[i] = i * i;
    for (int const threads : { 1, 2, 5 })
        for (std::size_t const slots : { 1u, 3u, 8u })
            EXPECT_EQ(on_threads(threads, [&] { return squares(1000, slots, 2000); }), expected)
                << threads << " threads, " << slots << " slots";
}

TEST(ParallelInOrder, EndsWhenAUserHasEnough)
{
    for (int const threads : { 1, 5 })
        EXPECT_EQ(on_threads(threads, [] { return squares(1000, 4, 3); }),
                  (std::vector<std::size_t> { 0, 1, 4 }));
}

TEST(ParallelInOrder, DoesNothingWhereThereIsNothing)
{
    EXPECT_TRUE(squares(0, 2, 1).empty());
}

std::ptrdiff_t thread_count()
{
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

TEST(WorkerThreads, AreGoneWhenTheyAreEnded)
{
    end_worker_threads(); // Ends the worker threads that other tests have started.
    auto const before = thread_count();
    bool were_there = false;
    for (int round = 0; round < 20; ++round) {
        std::atomic<std::size_t> sum = 0;
        parallel_for(10'000, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
                sum += i;
        });
        were_there |= thread_count() > before;
        end_worker_threads();
        // The kernel lists a thread for a moment even after it was joined.
        for (int looks = 0; looks < 100'000 && thread_count() > before; ++looks)
            std::this_thread::yield();
        EXPECT_EQ(thread_count(), before) << "round " << round;
    }
    EXPECT_TRUE(were_there || std::thread::hardware_concurrency() < 2);
}

} // namespace
} // namespace tractus
