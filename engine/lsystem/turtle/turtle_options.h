#pragma once

#include "engine/lsystem/language/limits.h"

#include <cstddef>
#include <functional>
#include <string_view>

namespace tractus::lsystem {

struct TurtleOptions {
    double unit_mm = 10;                   // Length of one turtle unit.
    std::size_t max_modules = 100'000'000; // Drawn ones, after homomorphism.
    std::size_t max_parts = 4'000'000;     // Segments, organs and polygons: what memory can hold.
    std::size_t max_memory_bytes = ModelLimits().max_memory_bytes; // Memory of what is drawn.
    // A branch of at least so many modules may be drawn by another thread, if at least so many
    // follow it. The plant is the same; the default keeps a branch in a processor's second cache.
    std::size_t long_branch = 8192;
    TimeLimit time {}; // Time for homomorphism rules.
    // Takes what printf in homomorphism rules prints; nothing does by default.
    std::function<void(std::string_view text)> print {};
};

} // namespace tractus::lsystem
