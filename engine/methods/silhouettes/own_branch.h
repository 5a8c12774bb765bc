#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The one of the trunk's branches that a stroke is a branch of: it begins on it and not on the
// trunk, and does not come back; no value: there is none.
//
// It begins on a branch if it begins within 2.5 % of the outline's diagonal of that one's curve,
// nearer to it than to all others and to the trunk, and at least 2 % of the diagonal away from the
// trunk. The system and the stroke are in the same millimetres.
std::optional<std::size_t> bearer_of(BranchingSystem const& system, std::span<Vec2 const> stroke);

// Gives branches the strokes that were drawn on them. A branch that was a copy is one no more;
// copies of a branch stay copies of it. Strokes on branches that there are not are left out.
void take_own_branches(BranchingSystem& system, std::span<OwnBranch const> branches);

// Adds a stroke to a drawing as a branch of the branch that it begins on. Fails, as the user's
// fault, where it begins on none or is shorter than 2 % of that one, and like infer_system().
Result<void> add_own_branch(Drawing& drawing, std::vector<Vec2> stroke, StyleTo style_to,
                            SkeletonOptions const& options = {});

// What the branch is called that add_own_branch() would give the stroke to; no value: none.
Result<std::optional<std::string>> branch_borne_by(Drawing const& drawing,
                                                   std::span<Vec2 const> stroke,
                                                   SkeletonOptions const& options = {});

} // namespace tractus::silhouette
