#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::leaf {

// The strokes that form the outline of a leaf.
struct FoundOutline {
    RecognisedLeaf::Edge edge = RecognisedLeaf::Edge::Whole;
    std::vector<std::size_t> strokes {};
    // Index of the midrib, if it closes a half outline.
    std::optional<std::size_t> midrib {};
    // Outline as references to points of the strokes (stroke index, point index), in order. Closed,
    // unless it is only one half.
    struct Point {
        std::size_t stroke = 0;
        std::size_t point = 0;
    };
    std::vector<Point> line {};
};

// Finds the outline among strokes in the drawing plane, in millimetres with evenly spaced points.
// Fails with a user error that says what to draw.
Result<FoundOutline> find_outline(std::span<FlatLine const> strokes);

} // namespace tractus::leaf
