#pragma once

#include <cstddef>
#include <functional>

namespace tractus {

// Calls work(begin, end) for pieces that together make up [0, count), on as many threads as the
// machine has; pieces have about `grain` elements, at least one. Returns when all are done. What
// `work` writes must not depend on how the pieces are cut or in which order they run. Loops may be
// nested.
//
// All parallel loops go through here: the library that runs them is not built for the thread
// sanitizer, so this is where the sanitizer is told of the order between the caller and the pieces.
void parallel_for(std::size_t count, std::size_t grain,
                  std::function<void(std::size_t begin, std::size_t end)> const& work);

// How many threads parallel_for() may use here.
int thread_count();

} // namespace tractus
