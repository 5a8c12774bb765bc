#pragma once

#include "engine/methods/silhouettes/branching_system.h"

#include <optional>
#include <vector>

namespace tractus::silhouette {

// Matches branches across a change of the outline: for each branch of `later`, the index of the
// branch of `earlier` that it continues, so that lines drawn on the old branch can be assigned to
// the new one. Branches with the same stroke match. Otherwise two match if the shared area of their
// crowns is at least half of the larger crown; best pairs are taken first, each branch at most
// once. The origins must be equal, or one Bump and the other Drawn. No value: a new branch.
std::vector<std::optional<std::size_t>> match_branches(BranchingSystem const& earlier,
                                                       BranchingSystem const& later);

} // namespace tractus::silhouette
