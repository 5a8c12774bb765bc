#pragma once

#include "engine/lsystem/language/limits.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace tractus::lsystem {

struct TurtleOptions {
    double unit_mm = 10;                   // Length of one turtle unit.
    std::size_t max_modules = 100'000'000; // Limit on modules drawn, counted after homomorphism.
    std::size_t max_parts = 4'000'000;     // Limit on the number of segments, organs and polygons.
    // Limit on the memory of the drawing.
    std::size_t max_memory_bytes = ModelLimits().max_memory_bytes;
    // A branch of at least this many modules may be drawn by another thread if at least as many
    // follow it. The plant is the same; the default fits a branch into a processor's level 2 cache.
    std::size_t long_branch = 8192;
    TimeLimit time {}; // Time limit for homomorphism rules.
    // Receives the output of printf in homomorphism rules; by default it is discarded.
    std::function<void(std::string_view text)> print {};
};

} // namespace tractus::lsystem
