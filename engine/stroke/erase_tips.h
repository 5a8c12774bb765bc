#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <cstddef>
#include <span>

namespace tractus {

// Tips of a stroke that follow each other: the first and the last of them, counted from 0.
struct TipRange {
    std::size_t first = 0;
    std::size_t last = 0;

    bool operator==(TipRange const&) const = default;
};

// Takes tips away, as an eraser does on paper. What remains is one stroke: it begins later or ends
// earlier where an end is gone, and goes straight over a gap, since a branch has none; the gap can
// be redrawn (oversketch.h). The tips that remain are as they were.
//
// Refuses, in a sentence, ranges of which there is none, that are not in order, share a tip or
// leave the stroke, and those that leave nothing with a direction (stroke_points).
Result<Stroke> erase_tips(Stroke const& drawn, std::span<TipRange const> ranges);

} // namespace tractus
