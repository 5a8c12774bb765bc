#pragma once

#include "engine/methods/silhouettes/branching_system.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// Which branch of an earlier system each branch of a later one is, where the outline was changed in
// between: what was drawn on the one belongs to the other. One stroke on a branch is one branch;
// crowns that cover at least half of either one's area are the same branch, the best pairs first; a
// branch has one partner at most, of the same origin, or of a bump for a drawn one and the other
// way round. No value: it is new.
std::vector<std::optional<std::size_t>> match_branches(BranchingSystem const& earlier,
                                                       BranchingSystem const& later);

} // namespace tractus::silhouette
