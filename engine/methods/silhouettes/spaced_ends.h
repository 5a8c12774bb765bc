#pragma once

#include "engine/methods/silhouettes/branch.h"

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Divides a crown's outline where it has no bumps, so that a crown gets as many branches as its
// form has, however smooth or rough its outline is drawn (an extension of Wither 2009, which has
// branches in bumps and copies of these alone). Bumps and drawn branches keep their parts of the
// outline (a bump up to three parts of 1/`branches`), the trunk's two ends one part each; what
// remains is divided evenly.

// Input of spaced_branches().
struct CrownToDivide {
    std::span<Vec2 const> outline; // Equally spaced, counter-clockwise.
    std::span<Bump const> bumps;   // Bumps with assigned roles.
    // The search for branches; its trunk may be longer than the one drawn.
    BranchSearch const& search;
    std::span<Vec2 const> drawn_ends; // Ends of drawn branches that end in no bump.
    std::size_t has = 0;              // Number of branches that the crown has already.
    std::size_t branches = 0;         // Number of branches that the crown should have.
};

struct SpacedBranch {
    BranchCurve path {};
    // The part of the outline to which the branch goes, like a bump's.
    Bump part {};
    // Position of the part on the outline, in units of a quarter of a part; identifies the branch.
    std::size_t number = 0;
};

// The branches to be added, at most as many as the crown lacks; on each side of the trunk from its
// base to its top. Each leaves the trunk at the angle of its base, straight to its part of the
// outline, or like an inferred branch where the straight way leaves the outline.
std::vector<SpacedBranch> spaced_branches(CrownToDivide const& crown);

// The part of the outline that an end of the trunk keeps: the bump's cap, or one part of
// 1/`branches` of the outline around its tip if that is longer.
Arc kept_by_trunk(std::span<Vec2 const> outline, Bump const& bump, std::size_t branches);

} // namespace tractus::silhouette
