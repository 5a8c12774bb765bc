#pragma once

#include "engine/base/result.h"
#include "engine/methods/leaves/flat_line.h"
#include "engine/methods/leaves/leaf_drawing.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tractus::leaf {

// Which strokes are a leaf's edge.
struct FoundOutline {
    RecognisedLeaf::Edge edge = RecognisedLeaf::Edge::Whole;
    std::vector<std::size_t> strokes {};
    // Known at once where it closes a half outline.
    std::optional<std::size_t> midrib {};
    // Points of the strokes, in order: which stroke, which of its points. Closed, but for one half.
    struct Point {
        std::size_t stroke = 0;
        std::size_t point = 0;
    };
    std::vector<Point> line {};
};

// Looks at strokes in the drawing's plane, in millimetres, with points at even distances. Fails, as
// the user's fault, with what to draw.
Result<FoundOutline> find_outline(std::span<FlatLine const> strokes);

} // namespace tractus::leaf
