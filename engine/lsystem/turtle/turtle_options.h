#pragma once

#include "engine/lsystem/language/limits.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace tractus::lsystem {

struct TurtleOptions {
    double unit_mm = 10;                   // Length of one turtle unit.
    std::size_t max_modules = 100'000'000; // Maximum number of modules to draw, after homomorphism.
    std::size_t max_parts = 4'000'000;     // Maximum number of segments, organs and polygons.
    // Maximum memory for the drawing.
    std::size_t max_memory_bytes = ModelLimits().max_memory_bytes;
    // Minimum number of modules of a branch that another thread may draw; at least as many modules
    // must follow the branch. The plant does not depend on it. A branch of the default size fits
    // into a processor's level 2 cache.
    std::size_t long_branch = 8192;
    TimeLimit time {}; // Time limit for homomorphism rules.
    // Receives the output of printf in homomorphism rules; by default it is discarded.
    std::function<void(std::string_view text)> print {};
};

} // namespace tractus::lsystem
