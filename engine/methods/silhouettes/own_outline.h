#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The branch of a system that a closed stroke is the own outline of, rather than one of the whole
// crown or of nothing; no value: there is none.
//
// `shared`: what the two share, of what they cover together.
//
// Such a stroke is clearly smaller than the crown: it encloses at most half of the crown's area,
// and at most half of the trunk inside the crown. It lies around the branch: the branch ends in
// it, it encloses at least a third of the branch's crown, and what the two share is at least a
// fifth of what they cover together. Of several branches it belongs to the one with which it shares
// most of that. The system and the stroke are in the same millimetres.
struct OutlinedBranch {
    std::size_t branch = 0;
    double shared = 0;
};
std::optional<OutlinedBranch> outlined_in(BranchingSystem const& system,
                                          std::span<Vec2 const> stroke);
std::optional<std::size_t> branch_in(BranchingSystem const& system, std::span<Vec2 const> stroke);

// Gives branches the outlines that were drawn for them as their crowns. A branch that was a copy is
// one no more; copies of a branch are copies of what was drawn, as large as their places allow.
// All other branches of the system stay. What belongs to no branch, or does not hold its branch's
// end, is left out. `coverage_after` becomes that of the new crowns.
void take_own_outlines(BranchingSystem& system, std::span<OwnOutline const> outlines);

// Adds a closed stroke to a drawing as the own outline of the branch that it lies around, in place
// of the one that this has, and declares it a leaf if it is to be one; one that is a leaf stays
// one. Fails, as the user's fault, where it lies around none, and like infer_system() and
// clean_drawing().
Result<void> add_own_outline(Drawing& drawing, std::vector<Vec2> stroke,
                             SkeletonOptions const& options = {}, StyleTo style_to = StyleTo::None,
                             Search search = Search::OnTrunk, bool is_leaf = false);

// The path of the branch that add_own_outline() would give the stroke to; no value: none.
Result<std::optional<std::string>> branch_outlined_by(Drawing const& drawing,
                                                      std::span<Vec2 const> stroke,
                                                      SkeletonOptions const& options = {},
                                                      Search search = Search::OnTrunk);

} // namespace tractus::silhouette
