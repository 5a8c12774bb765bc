#pragma once

#include "engine/lsystem/fast_drawing/branch_index.h"
#include "engine/lsystem/fast_drawing/interpret.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Range of the magnitudes of a string's parameters.
struct ParameterRange {
    bool has_zero = false;
    float greatest = 0; // Largest magnitude of a parameter; infinite if one is infinite or NaN.

    bool are_finite() const { return greatest <= std::numeric_limits<float>::max(); }
};
ParameterRange parameter_range(ModuleString const& string);

// A part of the string, without the branches left to other pieces, and the number of segments that
// it draws.
struct PlannedPiece {
    // A branch that another piece draws.
    struct Gap {
        std::size_t opening = 0; // Index of the bracket that opens the branch.
        std::size_t piece = 0;
    };

    std::size_t begin = 0; // First module of the piece; the piece is [begin, end) of the string.
    std::size_t end = 0;
    // Index of the first parameter of module `end`; not set for the first piece.
    std::size_t end_parameter = 0;
    std::int64_t depth = 0; // Bracket depth of the first module.
    std::vector<Gap> gaps;
    // Number of segments of each axis, in the order in which the axes begin.
    std::vector<std::uint32_t> axis_lengths;
    // Number of axes and segments, including those of the pieces that fill the gaps.
    std::size_t axis_count = 0;
    std::size_t segment_count = 0;
};

// Counts the axes and segments of each part of a long string before any is drawn. Any thread can
// then draw each part directly to its place in the plant. The first piece is the outermost; the
// others come after the piece whose gap they fill. No value for strings whose symbols are as hard
// to count as to draw, or that cannot be drawn in parallel.
std::optional<std::vector<PlannedPiece>>
plan_segments(Model const& model, ModuleString const& string, TurtleOptions const& options,
              BranchIndex const& index, ParameterRange const& parameters);

} // namespace tractus::lsystem
