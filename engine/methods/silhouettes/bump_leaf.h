#pragma once

#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The branch that ends in a touched bump, to be declared a leaf.
struct BumpLeaf {
    std::string branch; // Path of the branch (Skeleton::at()).
    // The branch's part of the crown's outline, in millimetres of the drawing.
    std::vector<Vec2> outline;
};

// Finds the branch that ends in the touched bump (touched_bump(), bump_touch.h) of the smallest
// outline that has a bump there. Search::OnTrunk considers only the crown's outline. No value if
// there is no bump, if no branch ends in the bump (as in the trunk's foot or apex), or if the touch
// is farther than 4 % of the outline's diagonal from that branch's part of the crown.
std::optional<BumpLeaf> leaf_on_bump(Skeleton const& skeleton, Vec2 const& place, Search search);

} // namespace tractus::silhouette
