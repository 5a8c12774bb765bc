#pragma once

#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <cstddef>
#include <span>

namespace tractus {

// A range of consecutive tips of a stroke: the indices of its first and last tip, counted from 0.
struct TipRange {
    std::size_t first = 0;
    std::size_t last = 0;

    bool operator==(TipRange const&) const = default;
};

// Removes ranges of tips from a stroke, as an eraser does on paper. The result is one stroke. It is
// shorter where an end was erased, and a straight line bridges each gap, since a branch cannot have
// a gap; the line can be redrawn (oversketch.h). The remaining tips are unchanged.
//
// Fails, in one sentence, if there are no ranges, if they are not in order, overlap or exceed the
// stroke, or if the remaining tips have no direction (stroke_points).
Result<Stroke> erase_tips(Stroke const& drawn, std::span<TipRange const> ranges);

} // namespace tractus
