#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/sketch_lsystem/segment_lengths.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::sketch {

// Divides a stroke into the segments of a drawn axis while it is drawn (Ijiri et al. 2006, section
// 3.2): a node stands wherever the stroke leaves the ball around the last node whose radius is the
// length of the next internode. Chords count, not lengths along the curve, and nodes lie exactly on
// the spheres, so they do not depend on how densely the same curve is sampled. Going back into the
// ball changes nothing: the number of nodes never falls.
//
// push() takes constant time for each node that it makes, and allocates nothing.
class StrokeResampler {
public:
    explicit StrokeResampler(SegmentLengths lengths);
    explicit StrokeResampler(Rule const& rule)
        : StrokeResampler(lengths_of(rule))
    {
    }

    // The next tip, in any frame of millimetres; one that is not finite is left out. Returns how
    // many segments it has completed: how often the rule is applied now.
    int push(Vec3 const& tip_mm);

    // The first tip and the segments' ends; empty before the first tip.
    std::span<Vec3 const> nodes_mm() const { return nodes_mm_; }
    int segments() const { return nodes_mm_.empty() ? 0 : static_cast<int>(nodes_mm_.size()) - 1; }

    // The axis has as many segments as it may, or its next one would be shorter than any may be: it
    // does not follow the pen any more.
    bool is_full() const;

    // The length of the next segment.
    double next_length_mm() const { return next_length_mm_; }

private:
    SegmentLengths lengths_;
    double next_length_mm_;
    std::size_t most_nodes_;
    std::vector<Vec3> nodes_mm_;
    Vec3 last_tip_mm_ = Vec3::Zero();
};

// The nodes of a whole stroke.
std::vector<Vec3> resample_stroke(SegmentLengths const& lengths, std::span<Vec3 const> tips_mm);
std::vector<Vec3> resample_stroke(Rule const& rule, std::span<Vec3 const> tips_mm);

} // namespace tractus::sketch
