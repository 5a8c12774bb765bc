#pragma once

#include <cstddef>
#include <functional>

namespace tractus {

// Calls work(begin, end) for pieces that together cover [0, count), on as many threads as the
// machine has. Returns when all pieces are done. Only pieces of more than `grain` elements are
// split further; each piece has at least one element. The result of `work` must not depend on how
// the range is split or in which order the pieces run. Loops may be nested.
//
// Every parallel loop must go through this function: the library behind it is not built for the
// thread sanitizer, so this is where the sanitizer learns the order between the caller and the
// pieces.
void parallel_for(std::size_t count, std::size_t grain,
                  std::function<void(std::size_t begin, std::size_t end)> const& work);

// Returns the number of threads that parallel loops may use on this machine.
int thread_count();

// The three stages of parallel_in_order(). A slot is the storage of one piece of work while it
// passes through the stages, numbered from 0 to slots - 1.
struct OrderedWork {
    // Puts the next piece into a slot; returns false if there are no more. Called for one piece at
    // a time.
    std::function<bool(std::size_t slot)> next;
    // Does the long part of the work. Called for several slots at once, on any thread.
    std::function<void(std::size_t slot)> make;
    // Consumes a finished piece. Called for one piece at a time, in the order of next(). Returning
    // false ends the run: pieces in progress are dropped.
    std::function<bool(std::size_t slot)> use;
};

// Runs work whose results are needed in order, such as the parts of a file: while one piece is
// used, others are made. Returns when all pieces are done. `slots` must be at least 1. With
// thread_count() + 1 slots all threads are kept busy; with fewer, some wait.
void parallel_in_order(std::size_t slots, OrderedWork const& work);

} // namespace tractus
