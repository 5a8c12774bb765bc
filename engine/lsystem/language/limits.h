#pragma once

#include <cstddef>
#include <functional>
#include <limits>

namespace tractus::lsystem {

// A time limit for work on a model. The engine itself has no clock; the caller provides one.
struct TimeLimit {
    // Callback that any thread may call after every 65,536 modules, rule applications or loop
    // iterations; returning true ends the work with an error. Empty: no time limit.
    std::function<bool()> is_over {};
    double seconds = 0; // Duration that the error message names.
};

// Limits of a model's derivation. Memory counts the strings only, not the plant.
struct ModelLimits {
    std::size_t max_modules = 100'000'000;
    std::size_t max_memory_bytes = std::numeric_limits<std::size_t>::max();
    TimeLimit time {};
};

// Maximum size of a string.
struct StringLimit {
    std::size_t modules = ModelLimits().max_modules;
    std::size_t bytes = ModelLimits().max_memory_bytes;
};

} // namespace tractus::lsystem
