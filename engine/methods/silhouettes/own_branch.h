#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/skeleton.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::silhouette {

// The branches that a search considers.
enum class Search {
    OnTrunk,  // The trunk's branches only.
    AnyLevel, // The trunk's branches and the children of branches that were drawn on.
};

// The branch of a system at a point, and its distance from the point; no value if there is none.
//
// A point is on a branch if the branch's axis is at most 2.5 % of the outline's diagonal away and
// nearer than the trunk and all other branches, and if the trunk is at least 2 % of the diagonal
// away. The apex branch is not considered.
struct NearestBranch {
    std::size_t branch = 0;
    double distance = 0;
};
std::optional<NearestBranch> branch_near(BranchingSystem const& system, Vec2 const& place);

// The nearest branch at a point, over all systems of the skeleton whose branches may be drawn on.
std::optional<BranchRef> branch_near(Skeleton const& skeleton, Vec2 const& place);

// The branch of a system that is the parent of a stroke: the stroke begins on it (branch_near())
// and is not closed. No value if there is no such branch. The system and the stroke share one
// frame, in millimetres.
std::optional<std::size_t> parent_of(BranchingSystem const& system, std::span<Vec2 const> stroke);

// Attaches drawn strokes to the branches of a system. A copy that gets a stroke is no longer a
// copy; copies of a branch that gets a stroke remain copies of that branch. Strokes on branches
// that do not exist are ignored.
void take_own_branches(BranchingSystem& system, std::span<OwnBranch const> branches);

// Adds a stroke to a drawing as a child of the branch on which it begins. Fails with a user error
// if the stroke begins on no branch or is shorter than 2 % of that branch, and like infer_system().
Result<void> add_own_branch(Drawing& drawing, std::vector<Vec2> stroke, StyleScope style_to,
                            SkeletonOptions const& options = {}, Search search = Search::OnTrunk);

// Path of the branch to which add_own_branch() would attach the stroke; no value if there is no
// such branch.
Result<std::optional<std::string>> parent_of_drawn_branch(Drawing const& drawing,
                                                          std::span<Vec2 const> stroke,
                                                          SkeletonOptions const& options = {},
                                                          Search search = Search::OnTrunk);

} // namespace tractus::silhouette
