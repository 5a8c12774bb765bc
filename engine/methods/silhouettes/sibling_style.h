#pragma once

#include "engine/methods/silhouettes/skeleton.h"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace tractus::silhouette {

// The style of a branch (Wither 2009, section 4.2), given by its children in the plane, without the
// child that continues from its tip.
struct ParentStyle {
    // A child of the branch, from which children of its siblings are copied.
    struct Child {
        double u = 0; // Position of the child, as a share of the parent's length.
        double angle_deg = 0;
        Branch branch; // The child itself, with the side of the parent that it is on.
    };

    double t = 0; // Position of the parent along the trunk, 0 to 1.
    Side side = Side::Left;
    double length = 0;              // Length of the parent, in the unit of its system.
    std::vector<Child> children {}; // Children from the parent's base to its tip, at least one.
    double spacing = 0;   // Mean distance between children, in the unit of `length`; 0 if there is
                          // only one child.
    double deviation = 0; // Standard deviation of the distances between children.
    bool is_of_own_outline = false;
    // True if the style also applies to deeper levels (StyleScope::Deeper).
    bool includes_deeper_levels = false;

    // Shares of the parent's length before the first child and up to the last one.
    double unbranched() const { return children.front().u; }
    double last() const { return children.back().u; }
    double mean_angle_deg() const;
};

// Returns the style of a branch; a style without children if the branch has none.
ParentStyle parent_style(Branch const& parent, BranchingSystem const& system);

// Replaces the children of a branch by ones in the style of its siblings that were drawn on: the
// two nearest along the trunk, or the only one. The first and last child are at the sources'
// positions, as shares of the length. Distances between children have the sources' mean and
// standard deviation in absolute length. Branching angles follow the sources' by position, and
// sides alternate as theirs do, seen from the trunk. Each child is a copy of the nearest source
// child on the same side, as large as fits into the crown: one third to one and a half times the
// size given by the ratio of the parents' lengths.
//
// `sources`: at least one, sorted by t.
void take_style(BranchingSystem& system, Branch const& parent, std::span<ParentStyle const> sources,
                std::uint64_t seed);

// Ends a branch in a copy of another branch's leaf, at the same relative position. The copy has the
// same size or, on a shorter branch, is scaled down with the branch; it shrinks further, to no less
// than a third, while more than a tenth of it would be outside the outline.
void take_leaf(Branch& branch, Branch const& source, std::span<Vec2 const> outline);

// Turns the ends of a system's branches, including the apex branch, into leaves like those of their
// siblings. This happens to a branch if it was not drawn on, if `may` returns true for it, and if
// the nearest branch that passes its style to siblings ends in a leaf.
void spread_leaves(BranchingSystem& system, std::function<bool(Branch const&)> const& may);

// True if the system has branches and all of them are leaves.
bool has_only_leaves(BranchingSystem const& system);

} // namespace tractus::silhouette
