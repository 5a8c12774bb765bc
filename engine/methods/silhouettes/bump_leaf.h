#pragma once

#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <optional>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The branch that ends in a bump, as what a touch there declares a leaf.
struct BumpLeaf {
    std::string branch;        // Its path.
    std::vector<Vec2> outline; // Its part of the crown, in millimetres of the drawing.
};

// The bump that a touch lies on is one of the smallest outline that has one there (touched_bump(),
// bump_touch.h); Search::OnTrunk looks at the crown's alone. No value: there is none, no branch
// ends in it, as in the one that the trunk comes in through or ends in, or the touch is outside of
// that branch's part of the crown by more than 4 % of the outline's diagonal.
std::optional<BumpLeaf> leaf_on_bump(Skeleton const& skeleton, Vec2 const& place, Search search);

} // namespace tractus::silhouette
