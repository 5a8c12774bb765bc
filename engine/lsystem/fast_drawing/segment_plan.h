#pragma once

#include "engine/lsystem/fast_drawing/branch_index.h"
#include "engine/lsystem/fast_drawing/interpret.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// How large a string's parameters are.
struct ParameterRange {
    bool has_zero = false;
    float greatest = 0; // Magnitude; infinite if any is infinite or not a number.

    bool are_finite() const { return greatest <= std::numeric_limits<float>::max(); }
};
ParameterRange parameter_range(ModuleString const& string);

// A part of a string, outside of the branches left out of it, and the segments that it draws.
struct PlannedPiece {
    // A branch that another piece draws.
    struct Gap {
        std::size_t opening = 0; // The module that begins it, a bracket.
        std::size_t piece = 0;
    };

    std::size_t begin = 0; // Modules.
    std::size_t end = 0;
    std::size_t end_parameter = 0; // Where those of the module at the end begin; not of the first.
    std::int64_t depth = 0;        // Depth in brackets of the first module.
    std::vector<Gap> gaps;
    std::vector<std::uint32_t> axis_lengths; // Segments; axes in the order in which they begin.
    // Counts include what fills its gaps.
    std::size_t axis_count = 0;
    std::size_t segment_count = 0;
};

// How many axes and segments the parts of a long string draw, counted before any is drawn: then
// each part can be drawn right to its place in the plant, by any thread. The first piece is the
// outermost, the others stand behind those whose gaps they fill. No value for strings with symbols
// that make counting as hard as drawing, and for those that no two threads can draw.
std::optional<std::vector<PlannedPiece>>
plan_segments(Model const& model, ModuleString const& string, TurtleOptions const& options,
              BranchIndex const& index, ParameterRange const& parameters);

} // namespace tractus::lsystem
