#pragma once

#include "engine/lsystem/fast_drawing/branch_index.h"
#include "engine/lsystem/fast_drawing/interpret.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace tractus::lsystem {

// Range of the magnitudes of all parameters of a string.
struct ParameterRange {
    bool has_zero = false;
    // Greatest magnitude of a parameter; infinite if a parameter is infinite or not a number.
    float greatest = 0;

    bool are_finite() const { return greatest <= std::numeric_limits<float>::max(); }
};
ParameterRange parameter_range(ModuleString const& string);

// A part of the string without the branches that are left to other pieces, and the number of
// segments that it draws.
struct PlannedPiece {
    // A branch that another piece draws.
    struct Gap {
        std::size_t opening = 0; // Index of the bracket that opens the branch.
        std::size_t piece = 0;
    };

    // First module of the piece, which is the range [begin, end) of the string.
    std::size_t begin = 0;
    std::size_t end = 0;
    // Index of the first parameter of module `end`; not set for the first piece.
    std::size_t end_parameter = 0;
    std::int64_t depth = 0; // Bracket depth at the first module.
    std::vector<Gap> gaps;
    // Number of segments of each axis, in the order in which the axes begin.
    std::vector<std::uint32_t> axis_lengths;
    // Number of axes and segments, including those of the pieces that fill the gaps.
    std::size_t axis_count = 0;
    std::size_t segment_count = 0;
};

// Counts the axes and segments of each part of a long string before any is drawn, so that any
// thread can then draw a part directly to its place in the plant. The first piece is the outermost;
// each other piece comes after the piece whose gap it fills. Returns no value for strings that
// cannot be drawn in parallel, or whose symbols are as hard to count as to draw.
std::optional<std::vector<PlannedPiece>>
plan_segments(Model const& model, ModuleString const& string, TurtleOptions const& options,
              BranchIndex const& index, ParameterRange const& parameters);

} // namespace tractus::lsystem
