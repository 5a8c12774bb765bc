#pragma once

#include <cstddef>
#include <functional>
#include <limits>

namespace tractus::lsystem {

// A time limit for work on a model. The engine itself reads no clock: the caller provides the
// check.
struct TimeLimit {
    // Returns true when the time is over; the work then ends with an error. Any thread may call it,
    // after every 65,536 modules, rule applications or loop iterations. Empty: no time limit.
    std::function<bool()> is_over {};
    double seconds = 0; // Length of the limit, for the error message.
};

// Limits of a model's derivation. Memory is that of the strings only, not of the plant.
struct ModelLimits {
    std::size_t max_modules = 100'000'000;
    std::size_t max_memory_bytes = std::numeric_limits<std::size_t>::max();
    TimeLimit time {};
};

// Maximum size of a string of modules.
struct StringLimit {
    std::size_t modules = ModelLimits().max_modules;
    std::size_t bytes = ModelLimits().max_memory_bytes;
};

} // namespace tractus::lsystem
