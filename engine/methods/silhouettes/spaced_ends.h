#pragma once

#include "engine/methods/silhouettes/branch.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Divides a crown's outline where it has no bumps, so that a crown gets as many branches as its
// form has, however smooth or rough its outline is drawn (an extension of Wither 2009, which only
// has branches in bumps and copies of these). A bump keeps up to three times the outline's length
// per branch; each drawn branch and each end of the trunk keeps that length once. The rest of the
// outline is divided evenly.

// Input of spaced_branches().
struct CrownToDivide {
    std::span<Vec2 const> outline; // The crown's outline: equally spaced points, counter-clockwise.
    std::span<Bump const> bumps;   // Bumps with assigned roles.
    // Input of the search for branches; its trunk may be longer than the drawn one.
    BranchSearch const& search;
    std::span<Vec2 const> drawn_ends; // Ends of the drawn branches.
    std::size_t has = 0;              // Number of branches that the crown has already.
    std::size_t branches = 0;         // Number of branches that the crown should have.
};

struct SpacedBranch {
    BranchCurve path {};
    // The part of the outline in which the branch ends, described as a bump.
    Bump part {};
    // Position of the part on the outline, in quarters of the outline's length per branch;
    // identifies the branch.
    std::size_t number = 0;
};

// The branches to be added, at most as many as the crown lacks. The branches of each side of the
// trunk are in order from the trunk's base to its top. Each leaves the trunk at the branching angle
// of its base and goes straight to its part of the outline; where the straight line would leave the
// outline, the branch is inferred instead (infer_branch()).
std::vector<SpacedBranch> spaced_branches(CrownToDivide const& crown);

// The part of the outline that belongs to an end of the trunk in the foot or apex bump: the bump's
// cap, or 1/`branches` of the outline around the bump's tip if that is longer.
Arc kept_by_trunk(std::span<Vec2 const> outline, Bump const& bump, std::size_t branches);

} // namespace tractus::silhouette
