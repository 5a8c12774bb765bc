#include "engine/base/parallel.h"

#include "engine/base/urgency.h"
#include "engine/base/worker_threads.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>
#include <vector>

// This file is compiled without the thread sanitizer, which cannot follow the tasks of oneTBB.
#ifdef TRACTUS_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address); // NOLINT(bugprone-reserved-identifier)
extern "C" void __tsan_release(void* address); // NOLINT(bugprone-reserved-identifier)
// The library passes its own memory between threads in ways that the sanitizer cannot see. This
// function suppresses reports about the library itself, not about our work functions in its
// threads.
extern "C" char const* __tsan_default_suppressions(); // NOLINT(bugprone-reserved-identifier)
extern "C" char const* __tsan_default_suppressions()  // NOLINT(bugprone-reserved-identifier)
{
    return "called_from_lib:libtbb.so";
}
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

#ifndef __has_feature
#define __has_feature(name) 0
#endif
#if __has_feature(address_sanitizer) || defined(__SANITIZE_ADDRESS__)
// Works around a bug of the address sanitizer's runtimes up to LLVM 16 and GCC 13: about one in a
// hundred blocks of thread-local storage is mistaken for one of an older glibc; the leak check at
// exit then reads a wrong address and crashes.
extern "C" char const* __asan_default_options(); // NOLINT(bugprone-reserved-identifier)
extern "C" char const* __asan_default_options()  // NOLINT(bugprone-reserved-identifier)
{
    return "intercept_tls_get_addr=0";
}
#endif

namespace tractus {

void end_worker_threads()
{
    tbb::task_scheduler_handle handle { tbb::attach {} };
    (void)tbb::finalize(handle, std::nothrow);
}

void parallel_for(std::size_t count, std::size_t grain,
                  std::function<void(std::size_t, std::size_t)> const& work)
{
    if (count == 0)
        return;
    grain = std::max<std::size_t>(grain, 1);
    if (count <= grain)
        return work(0, count);
    // The addresses of `begun` and `done` identify the loop's two synchronisation points for the
    // thread sanitizer.
    char begun = 0;
    char done = 0;
    auto const urgency = present_urgency();
    release(&begun);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain),
                      [&](tbb::blocked_range<std::size_t> const& range) {
                          acquire(&begun);
                          UrgencyScope const piece(urgency);
                          work(range.begin(), range.end());
                          release(&done);
                      });
    acquire(&done);
}

void parallel_in_order(std::size_t slots, OrderedWork const& work)
{
    // The addresses of these variables tell the thread sanitizer what a stage sees: what the
    // previous stage wrote to the slot, and the stage's own earlier writes.
    std::vector<char> slot_order(slots);
    char next_order = 0;
    char use_order = 0;
    std::atomic<bool> ended = false;
    std::size_t count = 0;
    auto const urgency = present_urgency();
    auto const ordered = [](char& own, char& of_slot, auto const& stage) {
        acquire(&own);
        acquire(&of_slot);
        bool const result = stage();
        release(&of_slot);
        release(&own);
        return result;
    };
    release(&next_order);
    auto const next = [&](tbb::flow_control& control) -> std::size_t {
        // This slot is free: at most `slots` pieces are in progress, and they finish in order.
        auto const slot = count++ % slots;
        if (ended || !ordered(next_order, slot_order[slot], [&] { return work.next(slot); }))
            control.stop();
        return slot;
    };
    auto const make = [&](std::size_t slot) {
        acquire(&slot_order[slot]);
        UrgencyScope const piece(urgency);
        if (!ended)
            work.make(slot);
        release(&slot_order[slot]);
        return slot;
    };
    auto const use = [&](std::size_t slot) {
        if (!ended && !ordered(use_order, slot_order[slot], [&] { return work.use(slot); }))
            ended = true;
    };
    using Mode = tbb::filter_mode;
    tbb::parallel_pipeline(slots,
                           tbb::make_filter<void, std::size_t>(Mode::serial_in_order, next)
                               & tbb::make_filter<std::size_t, std::size_t>(Mode::parallel, make)
                               & tbb::make_filter<std::size_t, void>(Mode::serial_in_order, use));
    acquire(&next_order);
    acquire(&use_order);
    for (char& order : slot_order) // Also synchronises with pieces that were made but not used.
        acquire(&order);
}

int thread_count()
{
    auto const allowed
        = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(allowed));
}

} // namespace tractus
