#pragma once

#include <cstddef>
#include <functional>

namespace tractus {

// Calls work(begin, end) for pieces that together make up [0, count), on as many threads as the
// machine has; pieces have about `grain` elements, at least one. Returns when all are done. What
// `work` writes must not depend on how the pieces are cut or in which order they run. Loops may be
// nested.
//
// Every parallel loop goes through here: the library that runs them is not built for the thread
// sanitizer, so this is where the sanitizer is told of the order between the caller and the pieces.
void parallel_for(std::size_t count, std::size_t grain,
                  std::function<void(std::size_t begin, std::size_t end)> const& work);

// How many threads parallel loops may use here.
int thread_count();

// Work of parallel_in_order(). A slot is where a piece of work is kept on its way: a number below
// the count of slots.
struct OrderedWork {
    // Puts the next piece into a slot; false where there is none. Called for one piece at a time.
    std::function<bool(std::size_t slot)> next;
    // The part that takes long: called for several slots at once, on any threads.
    std::function<void(std::size_t slot)> make;
    // Called for one piece at a time, in the order of next(). False ends everything: pieces that
    // are under way are dropped.
    std::function<bool(std::size_t slot)> use;
};

// Runs pieces of work whose results are needed in order, such as parts of a file: while one is used
// others are made. Returns when all are done. Pieces wait for each other where there are too few
// slots: one more than thread_count() keeps all threads busy. At least one slot.
void parallel_in_order(std::size_t slots, OrderedWork const& work);

} // namespace tractus
