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
    // Stroke index of the midrib, if the outline is one half that the midrib closes.
    std::optional<std::size_t> midrib {};
    // The outline's points in order, each as a stroke index and a point index within that stroke.
    // The outline is closed unless it is only one half.
    struct Point {
        std::size_t stroke = 0;
        std::size_t point = 0;
    };
    std::vector<Point> line {};
};

// Finds the outline among the strokes of a leaf. Their points are in the drawing plane, in
// millimetres and evenly spaced. Fails with a user error that says what to draw.
Result<FoundOutline> find_outline(std::span<FlatLine const> strokes);

} // namespace tractus::leaf
