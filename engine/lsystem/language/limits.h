#pragma once

#include <cstddef>
#include <functional>
#include <limits>

namespace tractus::lsystem {

// When work on a model has taken too long. The engine has no clock: its caller may have one.
struct TimeLimit {
    // Asked every 65,536 modules, rules applied or rounds of a loop, from any thread; true ends the
    // work with an error. Never asked where there is none.
    std::function<bool()> is_over {};
    double seconds = 0; // Seconds to be named in the message.
};

// Limits of a model's derivation. Memory is that of the strings; the plant comes on top.
struct ModelLimits {
    std::size_t max_modules = 100'000'000;
    std::size_t max_memory_bytes = std::numeric_limits<std::size_t>::max();
    TimeLimit time {};
};

// How large a string may become.
struct StringLimit {
    std::size_t modules = ModelLimits().max_modules;
    std::size_t bytes = ModelLimits().max_memory_bytes;
};

} // namespace tractus::lsystem
