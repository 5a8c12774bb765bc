#pragma once

#include "engine/plant/plant.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tractus::variation {

// A plant's segments as a tree from root to tip: the children of a segment are those that begin at
// its end, on its own axis or on axes attached there (Streit 2006, section 4.1, figure 4).
struct BranchTree {
    std::vector<SegmentId> parent;    // Parent of each segment; kNone if it is on the ground.
    std::vector<AxisId> axis;         // Axis of each segment.
    std::vector<std::uint32_t> depth; // Number of ancestor segments: 0 on the ground.
    // Index in `children` of each segment's first child, followed by the total number of children.
    std::vector<std::uint32_t> first_child;
    // The children of the first segment, then those of the second, and so on.
    std::vector<SegmentId> children;

    // Positions in a depth-first traversal: those of a segment and its descendants are the range
    // [rank, rank_end) of the segment.
    std::vector<std::uint32_t> rank;
    std::vector<std::uint32_t> rank_end;

    std::size_t size() const { return parent.size(); }

    std::span<SegmentId const> children_of(SegmentId segment) const
    {
        return std::span(children).subspan(first_child[segment],
                                           first_child[segment + 1] - first_child[segment]);
    }

    // True if `segment` is `ancestor` or one of its descendants.
    bool is_descendant(SegmentId segment, SegmentId ancestor) const
    {
        return rank[ancestor] <= rank[segment] && rank[segment] < rank_end[ancestor];
    }
};

BranchTree build_branch_tree(Plant const& plant);

// Returns the segments from `ancestor` up to its descendant `segment`, both included, in this
// order.
std::vector<SegmentId> path_between(BranchTree const& tree, SegmentId ancestor, SegmentId segment);

} // namespace tractus::variation
