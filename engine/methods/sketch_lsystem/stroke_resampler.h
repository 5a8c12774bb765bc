#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/segment_lengths.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::sketch {

// Divides a stroke into the segments of a drawn axis while it is being drawn (Ijiri et al. 2006,
// section 3.2). A new node is placed where the stroke leaves the ball around the last node; the
// ball's radius is the length of the next internode. Distances are measured along chords, and each
// node lies exactly on the ball's surface, so nodes do not depend on how densely the stroke is
// sampled. The number of nodes never falls, even if the pen goes back into the ball.
//
// push() takes constant time for each node that it makes, and allocates nothing.
class StrokeResampler {
public:
    explicit StrokeResampler(SegmentLengths lengths);
    explicit StrokeResampler(Rule const& rule)
        : StrokeResampler(lengths_of(rule))
    {
    }

    // Adds a position of the pen's tip, in millimetres; all positions must be in the same frame. A
    // position that is not finite is ignored. Returns the number of segments that the position
    // completes: the rule is to be applied once for each.
    int push(Vec3 const& tip_mm);

    // The first tip position and the ends of all segments; empty before the first push().
    std::span<Vec3 const> nodes_mm() const { return nodes_mm_; }
    int segments() const { return nodes_mm_.empty() ? 0 : static_cast<int>(nodes_mm_.size()) - 1; }

    // True if the axis no longer follows the pen, because it has reached its maximum number of
    // segments or its next segment would be too short.
    bool is_full() const;

    double next_length_mm() const { return next_length_mm_; }

private:
    SegmentLengths lengths_;
    double next_length_mm_;
    std::size_t most_nodes_;
    std::vector<Vec3> nodes_mm_;
    Vec3 last_tip_mm_ = Vec3::Zero();
};

// Compute the nodes of the drawn axis for a whole stroke.
std::vector<Vec3> resample_stroke(SegmentLengths const& lengths, std::span<Vec3 const> tips_mm);
std::vector<Vec3> resample_stroke(Rule const& rule, std::span<Vec3 const> tips_mm);

} // namespace tractus::sketch
