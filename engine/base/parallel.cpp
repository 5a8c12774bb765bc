#include "engine/base/parallel.h"

#include <algorithm>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

// This file is compiled without the thread sanitizer, since it cannot follow the library's tasks.
#ifdef TRACTUS_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address); // NOLINT(bugprone-reserved-identifier)
extern "C" void __tsan_release(void* address); // NOLINT(bugprone-reserved-identifier)
static void acquire(void* address)
{
    __tsan_acquire(address);
}
static void release(void* address)
{
    __tsan_release(address);
}
#else
static void acquire(void*) { }
static void release(void*) { }
#endif

namespace tractus {

void parallel_for(std::size_t count, std::size_t grain,
                  std::function<void(std::size_t, std::size_t)> const& work)
{
    if (count == 0)
        return;
    grain = std::max<std::size_t>(grain, 1);
    if (count <= grain)
        return work(0, count);
    char begun = 0; // Their addresses stand for the loop's two points of synchronisation.
    char done = 0;
    release(&begun);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](tbb::blocked_range<std::size_t> const& range) {
                          acquire(&begun);
                          work(range.begin(), range.end());
                          release(&done);
                      });
    acquire(&done);
}

int thread_count()
{
    return tbb::this_task_arena::max_concurrency();
}

} // namespace tractus
