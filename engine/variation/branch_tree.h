#pragma once

#include "engine/plant/plant.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// A plant's segments as an n-ary tree from root to tip: a segment's children begin where it ends,
// be it on its own axis or on those that stand on it (Streit 2006 section 4.1, figure 4).
struct BranchTree {
    std::vector<SegmentId> parent;          // kNone for what stands on the ground.
    std::vector<AxisId> axis;               // The axis of each segment.
    std::vector<std::uint32_t> depth;       // Segments below: 0 for what stands on the ground.
    std::vector<std::uint32_t> first_child; // Where each segment's children begin, and the end.
    std::vector<SegmentId> children;        // Children of all segments, in the segments' order.

    // Numbers from a walk through the tree: those of a segment and all its descendants are
    // [rank, rank_end).
    std::vector<std::uint32_t> rank;
    std::vector<std::uint32_t> rank_end;

    std::size_t size() const { return parent.size(); }

    std::span<SegmentId const> children_of(SegmentId segment) const
    {
        return std::span(children).subspan(first_child[segment],
                                           first_child[segment + 1] - first_child[segment]);
    }

    // True also for a segment and itself.
    bool is_descendant(SegmentId segment, SegmentId ancestor) const
    {
        return rank[ancestor] <= rank[segment] && rank[segment] < rank_end[ancestor];
    }
};

BranchTree build_branch_tree(Plant const& plant);

// The segments from `ancestor` down to its descendant `segment`, both among them, root end first.
std::vector<SegmentId> path_between(BranchTree const& tree, SegmentId ancestor, SegmentId segment);

} // namespace tractus::variation
