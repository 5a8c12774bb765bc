#include "engine/variation/branch_tree.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus::variation {

static void find_parents(Plant const& plant, BranchTree& tree)
{
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        SegmentId parent = axis.parent_segment;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            SegmentId const segment = axis.first_segment + i;
            tree.axis[segment] = id;
            tree.parent[segment] = parent;
            tree.depth[segment] = parent == kNone ? 0 : tree.depth[parent] + 1;
            parent = segment;
        }
    }
}

static void find_children(BranchTree& tree)
{
    for (auto const parent : tree.parent)
        if (parent != kNone)
            ++tree.first_child[parent + 1];
    for (std::size_t i = 1; i < tree.first_child.size(); ++i)
        tree.first_child[i] += tree.first_child[i - 1];
    tree.children.resize(tree.first_child.back());
    auto next = tree.first_child;
    for (SegmentId segment = 0; segment < tree.size(); ++segment)
        if (auto const parent = tree.parent[segment]; parent != kNone)
            tree.children[next[parent]++] = segment;
}

// Finds the positions in a depth-first traversal. Parents have lower numbers than their children,
// so two passes over the segments suffice, without a stack.
static void find_ranks(BranchTree& tree)
{
    auto const count = tree.size();
    std::vector<std::uint32_t> descendants(count, 1);
    for (std::size_t segment = count; segment-- > 0;)
        if (auto const parent = tree.parent[segment]; parent != kNone)
            descendants[parent] += descendants[segment];

    std::uint32_t next_root = 0;
    std::vector<std::uint32_t> next_in(count);
    for (SegmentId segment = 0; segment < count; ++segment) {
        auto const parent = tree.parent[segment];
        auto& next = parent == kNone ? next_root : next_in[parent];
        tree.rank[segment] = next;
        next += descendants[segment];
        tree.rank_end[segment] = next;
        next_in[segment] = tree.rank[segment] + 1;
    }
}

BranchTree build_branch_tree(Plant const& plant)
{
    auto const count = plant.segment_count();
    BranchTree tree;
    tree.parent.resize(count);
    tree.axis.resize(count);
    tree.depth.resize(count);
    tree.first_child.assign(count + 1, 0);
    tree.rank.resize(count);
    tree.rank_end.resize(count);
    find_parents(plant, tree);
    find_children(tree);
    find_ranks(tree);
    return tree;
}

std::vector<SegmentId> path_between(BranchTree const& tree, SegmentId ancestor, SegmentId segment)
{
    CHECK(tree.is_descendant(segment, ancestor));
    std::vector<SegmentId> path { segment };
    while (path.back() != ancestor)
        path.push_back(tree.parent[path.back()]);
    std::reverse(path.begin(), path.end());
    return path;
}

} // namespace tractus::variation
